//! The streams and test items of the studies, as numbers of syllables.

use cla_core::num::Rng;

use crate::world::shuffle;

/// Syllables of a language.
pub const SYLLABLES: usize = 12;
/// Words that are spoken in a stream.
pub const TOKENS: u32 = 180;

/// Three syllables.
pub type Item = [usize; 3];

/// Four words of three syllables each, drawn from twelve that no two share.
///
/// ```
/// use cla_core::num::Rng;
/// use host_sim::experiment::words::Language;
/// let language = Language::new(&mut Rng::new(1));
/// let [word, part_word] = language.tests()[0];
/// assert_ne!(word, part_word);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Language {
    words: [Item; 4],
}

impl Language {
    /// A language by chance.
    #[must_use]
    pub fn new(rng: &mut Rng) -> Self {
        let mut order: [usize; SYLLABLES] = core::array::from_fn(|it| it);
        shuffle(&mut order, rng);
        let word = |at: usize| [order[3 * at], order[3 * at + 1], order[3 * at + 2]];
        Self {
            words: [word(0), word(1), word(2), word(3)],
        }
    }

    /// The words.
    #[must_use]
    pub const fn words(&self) -> &[Item; 4] {
        &self.words
    }

    /// The stream of Saffran, Aslin and Newport (1996): 45 tokens of each word, none twice in a row.
    #[must_use]
    pub fn stream(&self, rng: &mut Rng) -> Vec<usize> {
        self.spoken(&tokens([45; 4], rng))
    }

    /// The stream of Aslin, Saffran and Newport (1998): two words twice as often as the other two, so
    /// that part-words of the frequent ones come as often as the rare words.
    #[must_use]
    pub fn uneven(&self, rng: &mut Rng) -> Vec<usize> {
        self.spoken(&tokens([45, 45, 90, 90], rng))
    }

    /// The first two words, each with a part-word of the last two: the end of one and the beginning of
    /// the other.
    #[must_use]
    pub const fn tests(&self) -> [[Item; 2]; 2] {
        let [first, second, third, fourth] = self.words;
        [
            [first, [third[2], fourth[0], fourth[1]]],
            [second, [fourth[2], third[0], third[1]]],
        ]
    }

    fn spoken(&self, tokens: &[usize]) -> Vec<usize> {
        tokens.iter().flat_map(|&word| self.words[word]).collect()
    }
}

/// So many tokens of each word in an order by chance, none twice in a row.
fn tokens(counts: [usize; 4], rng: &mut Rng) -> Vec<usize> {
    let mut order: Vec<usize> = counts
        .iter()
        .enumerate()
        .flat_map(|(word, &count)| vec![word; count])
        .collect();
    shuffle(&mut order, rng);
    // Swaps that lessen the repetitions; a swap that keeps their number lets one wander off.
    let repeats = |order: &[usize]| order.windows(2).filter(|it| it[0] == it[1]).count();
    while let Some(at) = order.windows(2).position(|it| it[0] == it[1]) {
        let other = rng.below(order.len() as u32) as usize;
        let before = repeats(&order);
        order.swap(at, other);
        if repeats(&order) > before {
            order.swap(at, other);
        }
    }
    order
}

/// The grammar of a sentence of Marcus and others (1999).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grammar {
    /// As in "ga ti ga".
    Aba,
    /// As in "ga ti ti".
    Abb,
}

impl Grammar {
    /// A sentence of two syllables.
    #[must_use]
    pub const fn sentence(self, a: usize, b: usize) -> Item {
        match self {
            Self::Aba => [a, b, a],
            Self::Abb => [a, b, b],
        }
    }

    /// The familiarization: each of sixteen sentences of four and four syllables three times.
    #[must_use]
    pub fn familiarization(self, rng: &mut Rng) -> Vec<Item> {
        let pairs = (0..3).flat_map(|_| (0..4).flat_map(|a| (4..8).map(move |b| (a, b))));
        let mut sentences: Vec<Item> = pairs.map(|(a, b)| self.sentence(a, b)).collect();
        shuffle(&mut sentences, rng);
        sentences
    }

    /// Two sentences of syllables that were never heard.
    #[must_use]
    pub const fn tests(self) -> [Item; 2] {
        [self.sentence(8, 9), self.sentence(10, 11)]
    }
}
