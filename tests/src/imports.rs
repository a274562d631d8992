//! Which file imports which, read from the sources: the graph that the architecture test holds.
//!
//! `use` trees and paths in code are resolved through `crate`, `self`, `super`, the names of the
//! project's crates and re-exports, to the file that defines the name.
//! Tests are left out, and a `mod.rs` that re-exports its own children does not import them.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use crate::Source;
use crate::tokens::tokens;

/// A path as it stands in the code, without the generics.
type Path = Vec<String>;

/// One file as far as imports go.
#[derive(Debug, Default)]
struct Module {
    path: String,
    /// What a name is imported as, and from where.
    uses: Vec<Use>,
    /// Paths in code that begin with a module.
    mentions: Vec<Path>,
    /// The macros it defines; they are found at the root of the crate.
    macros: Vec<String>,
}

#[derive(Debug)]
struct Use {
    path: Path,
    /// The name in this file; `*` for all.
    name: String,
    public: bool,
}

/// An import from one file to another.
///
/// ```
/// let it = cla_tests::imports::Import { from: "a.rs".into(), to: "b.rs".into() };
/// assert_eq!(it.to_string(), "a.rs imports b.rs");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Import {
    /// The file that imports.
    pub from: String,
    /// The file that defines what is imported.
    pub to: String,
}

impl fmt::Display for Import {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} imports {}", self.from, self.to)
    }
}

/// All imports between some files.
///
/// ```
/// use cla_tests::{Source, imports::Imports};
/// let file = |path: &str, text: &str| Source { path: path.into(), text: text.into() };
/// let imports = Imports::of(&[
///     file("cla-core/src/lib.rs", "mod a; mod b;"),
///     file("cla-core/src/a.rs", "use crate::b::B; pub struct A;"),
///     file("cla-core/src/b.rs", "pub struct B(Option<Box<super::a::A>>);"),
/// ]);
/// assert_eq!(imports.circles(), [["cla-core/src/a.rs", "cla-core/src/b.rs"]]);
/// // A macro is named at the root, wherever it is defined.
/// let imports = Imports::of(&[
///     file("cla-core/src/lib.rs", "mod a; mod b;"),
///     file("cla-core/src/a.rs", "fn a() { crate::make!() }"),
///     file("cla-core/src/b.rs", "#[macro_export] macro_rules! make { () => {} }"),
/// ]);
/// let all: Vec<_> = imports.iter().map(ToString::to_string).collect();
/// assert_eq!(all, ["cla-core/src/a.rs imports cla-core/src/b.rs"]);
/// ```
#[derive(Debug)]
pub struct Imports {
    all: BTreeSet<Import>,
}

impl Imports {
    /// Reads the imports of all sources.
    #[must_use]
    pub fn of(sources: &[Source]) -> Self {
        let tree = Tree::of(sources);
        let mut all = BTreeSet::new();
        for (at, module) in &tree.modules {
            let reexported = |it: &&Use| {
                !(it.public
                    && it.path.first().is_some_and(|first| {
                        let child = [at.as_slice(), std::slice::from_ref(first)].concat();
                        tree.modules.contains_key(&child)
                    }))
            };
            let used = module.uses.iter().filter(reexported).map(|it| &it.path);
            for path in used.chain(&module.mentions) {
                if let Some(to) = tree.file(at, path, 0)
                    && to != module.path
                {
                    let from = module.path.clone();
                    all.insert(Import { from, to });
                }
            }
        }
        Self { all }
    }

    /// Every import, in the order of the paths.
    pub fn iter(&self) -> impl Iterator<Item = &Import> {
        self.all.iter()
    }

    /// Every import within one circle.
    #[must_use]
    pub fn within(&self, circle: &[String]) -> Vec<&Import> {
        let inside = |it: &&Import| circle.contains(&it.from) && circle.contains(&it.to);
        self.iter().filter(inside).collect()
    }

    /// The circles: groups of files each of which imports every other one, directly or not.
    #[must_use]
    pub fn circles(&self) -> Vec<Vec<String>> {
        let mut from: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for it in &self.all {
            from.entry(&it.from).or_default().push(&it.to);
        }
        let reached: BTreeMap<&str, BTreeSet<&str>> = from
            .keys()
            .map(|&file| (file, reached(file, &from)))
            .collect();
        let mut circles: Vec<Vec<String>> = Vec::new();
        for (file, others) in &reached {
            let back = |other: &&&str| reached.get(**other).is_some_and(|it| it.contains(file));
            let circle: Vec<String> = others.iter().filter(back).map(|&it| it.into()).collect();
            if !circle.is_empty() && !circles.contains(&circle) {
                circles.push(circle);
            }
        }
        circles
    }
}

/// What a file imports, and what that imports, and so on; the file itself if it is among them.
fn reached<'a>(file: &'a str, from: &BTreeMap<&'a str, Vec<&'a str>>) -> BTreeSet<&'a str> {
    let (mut reached, mut next) = (BTreeSet::new(), vec![file]);
    while let Some(file) = next.pop() {
        for &to in from.get(file).into_iter().flatten() {
            if reached.insert(to) {
                next.push(to);
            }
        }
    }
    reached
}

/// The files by their place in the tree of modules; the first part of a place is the crate.
struct Tree {
    modules: BTreeMap<Path, Module>,
}

impl Tree {
    fn of(sources: &[Source]) -> Self {
        let mut modules = BTreeMap::new();
        for source in sources {
            if source.path.ends_with("_tests.rs") {
                continue;
            }
            let module = Module::read(source);
            modules.insert(place(&source.path), module);
        }
        Self { modules }
    }

    /// The file that defines what `path` names in the module `at`.
    fn file(&self, at: &[String], path: &[String], depth: u32) -> Option<String> {
        let (first, rest) = path.split_first()?;
        if depth > 16 {
            return None;
        }
        let parent = || at.split_last().map(|(_, parent)| parent.to_vec());
        let start = match first.as_str() {
            "crate" => vec![at.first()?.clone()],
            "self" => at.to_vec(),
            "super" => parent()?,
            _ => {
                let child = [at, std::slice::from_ref(first)].concat();
                let other = vec![first.clone()];
                if self.modules.contains_key(&child) {
                    child
                } else if let Some(it) = self.modules.get(at)?.imported(first) {
                    // An import of that name says where it comes from.
                    let path = [it.path.as_slice(), rest].concat();
                    return self.file(at, &path, depth + 1);
                } else if self.modules.contains_key(&other) {
                    other
                } else {
                    return None;
                }
            }
        };
        self.within(&start, rest, depth)
    }

    /// The file that defines what `path` names below the module `at`.
    fn within(&self, at: &[String], path: &[String], depth: u32) -> Option<String> {
        let Some((first, rest)) = path.split_first() else {
            return Some(self.modules.get(at)?.path.clone());
        };
        if first == "super" {
            let (_, parent) = at.split_last()?;
            return self.within(parent, rest, depth);
        }
        let child = [at, std::slice::from_ref(first)].concat();
        if self.modules.contains_key(&child) {
            return self.within(&child, rest, depth);
        }
        let module = self.modules.get(at)?;
        if let Some(it) = module.imported(first) {
            let path = [it.path.as_slice(), rest].concat();
            if let Some(found) = self.file(at, &path, depth + 1) {
                return Some(found);
            }
        }
        let by_macro = |(place, it): (&Path, &Module)| {
            (place.first() == at.first() && it.macros.contains(first)).then(|| it.path.clone())
        };
        let defined = (at.len() == 1).then(|| self.modules.iter().find_map(by_macro));
        Some(defined.flatten().unwrap_or_else(|| module.path.clone()))
    }
}

/// The place of a file in the tree of modules.
fn place(path: &str) -> Path {
    let mut parts: Vec<&str> = path.trim_end_matches(".rs").split('/').collect();
    let package = match parts[0] {
        "tests" => "cla_tests".to_owned(),
        package => package.replace('-', "_"),
    };
    // Every program, example and test is a crate of its own.
    let (root, inside) = match parts[1..] {
        ["src", "main"] => (format!("{package} main"), 3),
        ["src", "bin", program, ..] => (format!("{package} {program}"), 4),
        [kind @ ("tests" | "examples" | "benches"), program, ..] => {
            (format!("{package} {kind} {program}"), 3)
        }
        ["src", ..] => (package, 2),
        _ => (format!("{package} build"), parts.len()),
    };
    parts.drain(..inside);
    let mut place = vec![root];
    if matches!(parts.last(), Some(&("mod" | "lib" | "main"))) {
        parts.pop();
    }
    place.extend(parts.into_iter().map(str::to_owned));
    place
}

impl Module {
    fn read(source: &Source) -> Self {
        let mut module = Self {
            path: source.path.clone(),
            ..Self::default()
        };
        let tokens = without_tests(&tokens(&source.text));
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            let before = at.checked_sub(1).and_then(|at| tokens.get(at));
            if token == "macro_rules" {
                module.macros.extend(tokens.get(at + 2).cloned());
            }
            if token == "use" && before.is_none_or(|it| it != "::") {
                let public = before.is_some_and(|it| it == "pub" || it == ")");
                at += 1;
                module.read_use(&tokens, &mut at, &[], public);
            } else if is_name(token) && before.is_none_or(|it| it != "::" && it != ".") {
                let mut path = vec![token.clone()];
                while tokens.get(at + 1).is_some_and(|it| it == "::")
                    && tokens.get(at + 2).is_some_and(|it| is_name(it))
                {
                    path.push(tokens[at + 2].clone());
                    at += 2;
                }
                at += 1;
                if path.len() > 1 {
                    module.mentions.push(path);
                }
            } else {
                at += 1;
            }
        }
        module
    }

    /// Reads a tree of imports below `prefix`, up to what follows it.
    fn read_use(&mut self, tokens: &[String], at: &mut usize, prefix: &[String], public: bool) {
        let mut path = prefix.to_vec();
        while let Some(token) = tokens.get(*at).map(String::as_str) {
            match token {
                "::" => *at += 1,
                "{" => {
                    *at += 1;
                    while tokens.get(*at).is_some_and(|it| it != "}") {
                        self.read_use(tokens, at, &path, public);
                        if tokens.get(*at).is_some_and(|it| it == ",") {
                            *at += 1;
                        }
                    }
                    *at += 1;
                    return;
                }
                "*" => {
                    *at += 1;
                    let name = "*".to_owned();
                    self.uses.push(Use { path, name, public });
                    return;
                }
                "as" => {
                    let name = tokens[*at + 1].clone();
                    *at += 2;
                    self.uses.push(Use { path, name, public });
                    return;
                }
                "self" if !path.is_empty() => *at += 1,
                name if is_name(name) => {
                    path.push(name.to_owned());
                    *at += 1;
                }
                _ => break,
            }
        }
        if let Some(name) = path.last().cloned() {
            self.uses.push(Use { path, name, public });
        }
    }

    fn imported(&self, name: &str) -> Option<&Use> {
        self.uses.iter().find(|it| it.name == name)
    }
}

/// The tokens but for what follows `#[cfg(test)]`.
fn without_tests(tokens: &[String]) -> Vec<String> {
    let mark = ["#", "[", "cfg", "(", "test", ")", "]"];
    let (mut kept, mut at) = (Vec::new(), 0);
    while at < tokens.len() {
        if !tokens[at..].iter().map(String::as_str).take(7).eq(mark) {
            kept.push(tokens[at].clone());
            at += 1;
            continue;
        }
        // The item ends with its block, or with a semicolon outside of brackets.
        let mut depth = 0;
        at += mark.len();
        while let Some(token) = tokens.get(at) {
            at += 1;
            match token.as_str() {
                "{" | "(" | "[" => depth += 1,
                "}" | ")" | "]" => depth -= 1,
                _ => {}
            }
            if depth == 0 && (token == "}" || token == ";") {
                break;
            }
        }
    }
    kept
}

fn is_name(token: &str) -> bool {
    token.starts_with(|first: char| first.is_alphabetic() || first == '_')
}
