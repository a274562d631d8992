//! The streams are those of the studies, and a network that heard nothing prefers nothing.

use cla_core::num::Rng;

use super::{Grammar, Language, TOKENS, Words, WordsOptions, declared};
use crate::experiment::record::judged_again;

#[test]
fn a_stream_has_each_word_45_times_and_none_twice_in_a_row() {
    for seed in 0..20 {
        let mut rng = Rng::new(seed);
        let language = Language::new(&mut rng);
        let stream = language.stream(&mut rng);
        assert_eq!(stream.len(), 3 * TOKENS as usize);
        let words: Vec<&[usize]> = stream.chunks(3).collect();
        for word in language.words() {
            assert_eq!(words.iter().filter(|it| **it == word).count(), 45);
        }
        assert!(words.windows(2).all(|it| it[0] != it[1]));
    }
}

/// How often the second syllable follows the first, of all times that the first is heard.
fn follows(stream: &[usize], [first, second]: [usize; 2]) -> f64 {
    let pairs = || stream.windows(2).filter(|it| it[0] == first);
    pairs().filter(|it| it[1] == second).count() as f64 / pairs().count() as f64
}

#[test]
fn within_words_the_next_syllable_is_sure_and_in_part_words_it_comes_a_third_of_the_time() {
    let (mut sums, seeds) = ([0.0; 2], 20);
    for seed in 0..seeds {
        let mut rng = Rng::new(seed);
        let language = Language::new(&mut rng);
        let stream = language.stream(&mut rng);
        for [word, part_word] in language.tests() {
            assert!(follows(&stream, [word[0], word[1]]) > 0.999);
            assert!(follows(&stream, [part_word[1], part_word[2]]) > 0.999);
            sums[0] += follows(&stream, [part_word[0], part_word[1]]) / (2 * seeds) as f64;
        }
        let uneven = language.uneven(&mut rng);
        let heard = |item: &[usize]| uneven.windows(3).filter(|it| *it == item).count() as f64;
        for [word, part_word] in language.tests() {
            sums[1] += heard(&part_word) / heard(&word) / (2 * seeds) as f64;
        }
    }
    assert!((sums[0] - 1.0 / 3.0).abs() < 0.05, "{sums:?}");
    // Part-words of the frequent words come about as often as the rare words.
    assert!((0.7..1.3).contains(&sums[1]), "{sums:?}");
}

#[test]
fn no_test_sentence_has_a_syllable_that_was_heard() {
    for grammar in [Grammar::Aba, Grammar::Abb] {
        let heard = grammar.familiarization(&mut Rng::new(1));
        assert_eq!(heard.len(), 48);
        let fresh = |it: &usize| heard.iter().flatten().all(|heard| heard != it);
        assert!(grammar.tests().iter().flatten().all(fresh));
    }
}

#[test]
fn words_are_told_from_part_words_by_who_heard_them_and_by_nobody_else() {
    let results = judged_again::<Words>(&WordsOptions::standard((0..12).collect())).unwrap();
    let summary = &results.summary;
    let t = |id: &str| {
        summary
            .find(id)
            .unwrap()
            .tested
            .as_ref()
            .unwrap()
            .statistic
            .unwrap()
    };
    assert!(t("words.segmentation") > 3.0);
    assert!(t("words.unheard").abs() < 3.0);
    assert!(t("words.compared") > 3.0);
    let ids: Vec<_> = summary.claims.iter().map(|it| &it.id).collect();
    let known = declared();
    assert_eq!(ids, known.iter().map(|it| &it.id).collect::<Vec<_>>());
}
