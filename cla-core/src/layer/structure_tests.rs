//! Structures against layers wired by hand, value by value.

use super::{Input, Join, Layer, Scaled, Signal, Stack, StimulusError, Structure};
use crate::layer::{Delayed, LayerConfig, Recurrent, Window};
use crate::num::{Rng, Schedule};

/// A learning rate and a width that change with the number of samples.
fn config() -> LayerConfig {
    let alpha = Schedule::linear(0.5, 0.0, 50).unwrap();
    let width = Schedule::linear(1.0, 0.5, 50).unwrap();
    LayerConfig::try_new(0.5, alpha, width).unwrap()
}

fn started<const W: usize, const H: usize, const F: usize>(seed: u64) -> Layer<W, H, F> {
    let mut layer = Layer::new();
    layer.start(&config(), &mut Rng::new(seed));
    layer
}

fn values<const LEN: usize>(signal: &impl Signal) -> [f32; LEN] {
    // Places behind the signal stay as they are.
    let mut places = std::vec![9.0; LEN + 1];
    signal.write(&mut places.iter_mut());
    assert_eq!(places.pop(), Some(9.0));
    places.try_into().unwrap()
}

/// Two sensors: three numbers and one.
fn sensors(rng: &mut Rng) -> ([f32; 3], [f32; 1]) {
    (core::array::from_fn(|_| rng.unit()), [rng.unit()])
}

#[test]
fn a_stack_on_a_join_learns_as_its_layers_do_by_hand() {
    type Eye = Layer<2, 2, 3>;
    type Ear = Scaled<Layer<2, 1, 1>, 50>;
    let mut whole = Stack::<Join<Eye, Join<Ear, Input<1>>>, 3, 1, 7>::new();
    let (mut eye, mut ear, mut upper) = (started(1), started::<2, 1, 1>(2), started(3));
    whole.lower.first = eye.clone();
    whole.lower.second.first.source = ear.clone();
    whole.upper = upper.clone();
    let mut rng = Rng::new(4);
    for sample in 0..40 {
        let (shape, tone) = sensors(&mut rng);
        whole.learn(&(shape, (tone, tone)), sample).unwrap();
        eye.activate(&shape).unwrap();
        ear.activate(&tone).unwrap();
        let mut joined = [0.0; 7];
        joined[..4].copy_from_slice(eye.activation().as_slice());
        for (place, activation) in joined[4..6].iter_mut().zip(ear.activation().as_slice()) {
            *place = activation / 2.0;
        }
        joined[6] = tone[0];
        upper.activate(&joined).unwrap();
        eye.train(sample);
        ear.train(sample);
        upper.train(sample);
        assert_eq!(whole.lower.first, eye);
        assert_eq!(whole.lower.second.first.source, ear);
        assert_eq!(whole.upper, upper);
        assert_eq!(values::<7>(&whole.lower), joined);
        assert_eq!(values::<3>(&whole), upper.activation().as_slice());
    }
    // What is refused anywhere trains nothing anywhere.
    let before = whole.clone();
    let refused = whole.learn(&([0.5; 3], ([f32::NAN], [0.0])), 0);
    assert_eq!(refused, Err(StimulusError::NotFinite { feature: 0 }));
    assert_eq!(whole.upper, before.upper);
    assert_eq!(whole.lower.first.som(), before.lower.first.som());
}

#[test]
fn a_delay_a_window_and_a_loop_give_what_their_sources_gave_before() {
    type Source = Layer<2, 1, 1>;
    let source = started::<2, 1, 1>(1);
    let mut late = Delayed::<Source, 2, 3>::new();
    let mut window = Window::<Source, 2, 3>::new();
    (late.source, window.source) = (source.clone(), source.clone());
    let mut by_hand = source;
    let mut given: std::vec::Vec<[f32; 2]> = std::vec![[0.0; 2]; 3];
    let mut rng = Rng::new(2);
    for sample in 0..12 {
        let now = [rng.unit()];
        late.learn(&now, sample).unwrap();
        window.learn(&now, sample).unwrap();
        by_hand.learn(&now, sample).unwrap();
        given.push(values::<2>(&by_hand));
        let last = given.len() - 1;
        assert_eq!(values::<2>(&late), given[last - 3]);
        let held: std::vec::Vec<f32> = given[last - 2..].concat();
        assert_eq!(values::<6>(&window)[..], held[..]);
        assert_eq!(late.source, by_hand, "it is trained, too");
        assert_eq!(window.source, by_hand);
    }
    // The source's output before is the loop's second sensor now.
    type Inner = Stack<Join<Input<1>, Input<2>>, 2, 1, 3>;
    let mut looped = Recurrent::<Inner, 2, 2>::new();
    looped.source.upper = started(5);
    let mut by_hand = started::<2, 1, 3>(5);
    let mut given: std::vec::Vec<[f32; 2]> = std::vec![[0.0; 2]; 2];
    for sample in 0..12 {
        let now = rng.unit();
        looped.learn(&[now], sample).unwrap();
        let before = given[given.len() - 2];
        by_hand.learn(&[now, before[0], before[1]], sample).unwrap();
        given.push(values::<2>(&by_hand));
        assert_eq!(looped.source.upper, by_hand);
        assert_eq!(values::<2>(&looped), given[given.len() - 1]);
    }
}

#[test]
fn a_new_event_empties_whatever_holds_something_wherever_it_stands() {
    type Held = Window<Input<1>, 1, 3>;
    type Late = Scaled<Delayed<Input<1>, 1, 2>, 200>;
    type Inner = Stack<Join<Input<1>, Input<2>>, 2, 1, 3>;
    type Looped = Recurrent<Inner, 2, 1>;
    type Whole = Stack<Join<Held, Join<Late, Looped>>, 2, 2, 6>;
    let mut whole = Whole::new();
    whole.upper = started(1);
    whole.lower.second.second.source.upper = started(2);
    let show = |whole: &mut Whole, now: f32| {
        whole.activate(&([now], ([now], [now]))).unwrap();
        values::<6>(&whole.lower)
    };
    let mut first = std::vec::Vec::new();
    for now in [0.25, 0.5, 0.75] {
        first.push(show(&mut whole, now));
    }
    assert_eq!(first[0][..4], [0.0, 0.0, 0.25, 0.0]);
    assert_eq!(first[2][..4], [0.25, 0.5, 0.75, 0.5]);
    let upper = *whole.upper.activation().as_slice().first().unwrap();
    whole.forget_context();
    for (now, expected) in [0.25, 0.5, 0.75].into_iter().zip(&first) {
        assert_eq!(show(&mut whole, now), *expected);
    }
    assert_eq!(whole.upper.activation().as_slice()[0], upper);
    // In a window around a loop, and in a loop around a window, too.
    let mut nested = Window::<Looped, 2, 2>::new();
    nested.source.source.upper = started(2);
    let mut other =
        Recurrent::<Stack<Join<Window<Input<1>, 1, 2>, Input<2>>, 2, 1, 4>, 2, 1>::new();
    other.source.upper = started(3);
    let mut seen = std::vec::Vec::new();
    for event in 0..2 {
        for (step, now) in [0.25, 0.75].into_iter().enumerate() {
            nested.activate(&[now]).unwrap();
            other.activate(&[now]).unwrap();
            let values = (values::<4>(&nested), values::<2>(&other));
            if event == 0 {
                seen.push(values);
            } else {
                assert_eq!(values, seen[step]);
            }
        }
        nested.forget_context();
        other.forget_context();
    }
    let mut late = Delayed::<Window<Input<1>, 1, 2>, 2, 1>::new();
    for now in [[1.0], [2.0]] {
        late.activate(&now).unwrap();
    }
    late.forget_context();
    late.activate(&[4.0]).unwrap();
    assert_eq!(values::<2>(&late.source), [0.0, 4.0]);
}

#[test]
fn a_tuple_of_signals_is_their_join_however_many() {
    let (a, b, c, d) = ([1.0], [2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0, 10.0]);
    assert_eq!(values::<3>(&(a, b)), [1.0, 2.0, 3.0]);
    assert_eq!(values::<6>(&(a, b, c)), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    let all = values::<10>(&(a, b, c, d));
    assert!(all.into_iter().eq((1..=10_u8).map(f32::from)));
    fn len<S: Signal>(_: &S) -> usize {
        S::LEN
    }
    let lens = [
        len(&(a, b)),
        len(&(b, c)),
        len(&(b, c, c)),
        len(&(b, c, d, c)),
    ];
    assert_eq!(lens, [3, 5, 8, 12]);
    assert_eq!(len(&Join::<Input<2>, Input<3>>::new()), 5);
    assert_eq!(len(&Window::<Input<2>, 2, 3>::new()), 6);
    let line = crate::layer::DelayLine::<2, 3>::new();
    assert_eq!(len(&line), 6);
    assert_eq!(
        values::<2>(&Scaled::<_, 25> { source: [8.0, 2.0] }),
        [2.0, 0.5]
    );
}
