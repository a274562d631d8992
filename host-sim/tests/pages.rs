//! The page of a run in a browser: it fits a telephone and a desk, everything loads, tables sort.
//!
//! Needs Chromium, which `tests/run` installs on Debian; without it the test says so and passes.

use std::fs;
use std::process::Command;

use cla_core::agent::AgentConfig;
use host_sim::experiment::calibrate::{Calibrate, CalibrateOptions};
use host_sim::experiment::plan::run;
use host_sim::experiment::recover::life::Protocol;
use host_sim::experiment::recover::{Recover, RecoverOptions};
use host_sim::keeping::{Raised, Training, inspect, train};
use host_sim::logs::replayed;
use host_sim::progress::Progress;
use host_sim::report::escaped;
use host_sim::world::config::PioneerConfig;
use host_sim::world::damage::Damage;
use host_sim::world::setting::WorldOptions;
use serde_json::Value;

/// The names that the browser goes by.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

fn browser() -> Option<&'static str> {
    let starts = |name: &&str| Command::new(name).arg("--version").output().is_ok();
    NAMES.into_iter().find(starts)
}

/// Looks at a page in frames of both widths and says what is there; no window is as narrow as a
/// telephone, a frame is.
const LOOK: &str = r#"
const found = [];
function look(frame) {
  const page = frame.contentDocument, root = page.documentElement, width = root.clientWidth;
  const images = [...page.images];
  const wide = [...page.body.querySelectorAll("*")]
    .filter(it => !it.closest(".scroll, pre, figure.large, svg"))
    .filter(it => it.getBoundingClientRect().right > width + 1)
    .map(it => it.tagName + "." + it.className);
  const key = cell => "v" in cell.dataset
    ? (cell.dataset.v === "" ? null : Number(cell.dataset.v)) : cell.textContent.trim();
  const compare = (a, b) => typeof a === "number" && typeof b === "number"
    ? a - b : String(a).localeCompare(String(b), "en", { numeric: true });
  const unsorted = [];
  let clicks = 0, moved = 0;
  for (const table of page.querySelectorAll("table.sortable")) {
    const rows = () => [...table.tBodies[0].rows];
    const before = rows();
    [...table.tHead.rows[0].cells].forEach((head, column) => {
      for (const sign of [1, -1]) {
        const order = rows();
        head.querySelector("button").click();
        clicks++;
        moved += order.some((row, place) => row !== rows()[place]);
        const keys = rows().map(row => key(row.cells[column]));
        const there = keys.filter(it => it !== null);
        const sorted = there.every((it, place) => !place || sign * compare(there[place - 1], it) <= 0);
        const last = keys.slice(there.length).every(it => it === null);
        const said = head.getAttribute("aria-sort") === (sign > 0 ? "ascending" : "descending");
        const same = new Set([...before, ...rows()]).size === before.length;
        if (!(sorted && last && said && same)) unsorted.push(head.textContent);
      }
    });
  }
  const replay = page.querySelector(".replay");
  let played = null;
  if (replay) {
    // A life without damage has nothing to jump to.
    page.getElementById("jump")?.click();
    played = page.getElementById("now").textContent + " " + page.getElementById("scrub").value;
  }
  found.push({ width, scroll: root.scrollWidth, images: images.length, wide, unsorted, clicks, moved,
    broken: images.filter(it => !it.complete || !it.naturalWidth).length, played });
  document.getElementById("found").textContent = JSON.stringify(found);
}
"#;

/// What a browser says of a page at 390 and at 1280 pixels.
fn look(browser: &str, name: &str, page: &str) -> Vec<Value> {
    let frame = |width: u32| {
        let page = escaped(page);
        format!(
            "<iframe style=\"width:{width}px;height:800px;border:0\" onload=\"look(this)\" srcdoc=\"{page}\"></iframe>"
        )
    };
    let around = format!(
        "<!doctype html><meta charset=\"utf-8\"><script>{LOOK}</script><pre id=\"found\"></pre>{}{}",
        frame(390),
        frame(1280)
    );
    let folder = std::env::temp_dir().join(format!("host-sim-pages-{name}-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join("look.html");
    fs::write(&file, around).expect("a page");
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--dump-dom"])
        .args(["--enable-logging=stderr", "--window-size=1400,900"])
        .arg(format!(
            "--user-data-dir={}",
            folder.join("profile").display()
        ))
        .arg(format!("file://{}", file.display()))
        .output()
        .expect("the browser starts");
    let said = String::from_utf8_lossy(&output.stderr);
    let complaints: Vec<&str> = said.lines().filter(|it| it.contains("CONSOLE")).collect();
    assert!(complaints.is_empty(), "{name}: {complaints:#?}");
    let dom = String::from_utf8_lossy(&output.stdout);
    let found = dom.split("<pre id=\"found\">").nth(1);
    let found = found.and_then(|it| it.split("</pre>").next());
    let found = found.unwrap_or_else(|| panic!("{name}: the browser shows no page: {said}"));
    let found = found
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&amp;", "&");
    fs::remove_dir_all(&folder).expect("the folder can be removed");
    let found = serde_json::from_str(&found);
    let mut found: Vec<Value> = found.unwrap_or_else(|error| panic!("{name}: {error}"));
    // Frames load in any order.
    found.sort_by_key(|it| it["width"].as_i64());
    found
}

fn fits(name: &str, found: &[Value]) {
    let images = found.iter().all(|it| it["images"].as_i64() > Some(0));
    assert!(images, "{name}: {found:?}");
    fits_with_or_without_images(name, found);
}

fn fits_with_or_without_images(name: &str, found: &[Value]) {
    assert_eq!(found.len(), 2, "{name}: {found:?}");
    for (found, width) in found.iter().zip([390, 1280]) {
        // A frame that is long enough to scroll up and down may show a bar for it.
        let inner = found["width"].as_i64().unwrap_or_default();
        assert!((width - 20..=width).contains(&inner), "{name}: {found}");
        assert_eq!(found["scroll"], found["width"], "{name}: {found}");
        assert_eq!(found["wide"], serde_json::json!([]), "{name} at {width}");
        assert_eq!(found["broken"], 0, "{name}: {found}");
        assert_eq!(
            found["unsorted"],
            serde_json::json!([]),
            "{name} at {width}"
        );
        // Otherwise the heads do nothing.
        assert!(found["moved"].as_i64() > Some(5), "{name}: {found}");
    }
}

#[test]
fn pages_fit_a_telephone_and_a_desk_and_their_tables_sort() {
    let Some(browser) = browser() else {
        println!("skipped: there is no Chromium to look at pages with");
        return;
    };
    let calibrate = run::<Calibrate>(&CalibrateOptions::standard(), &Progress::hidden());
    let calibrate = calibrate.expect("it runs").page();
    fits("calibrate", &look(browser, "calibrate", &calibrate));
    // What does not fit and does not sort is noticed.
    let spoilt = calibrate.replacen("<main>", "<main><div style=\"width:900px\">x</div>", 1);
    let spoilt = spoilt.replace("a - b", "b - a");
    let found = look(browser, "spoilt", &spoilt);
    assert!(found[0]["scroll"].as_i64() > found[0]["width"].as_i64());
    assert_eq!(found[0]["wide"], serde_json::json!(["DIV."]));
    assert_ne!(found[1]["unsorted"], serde_json::json!([]));
    // Short lives: the page has all its parts.
    let options = RecoverOptions {
        seeds: vec![3, 4],
        world: WorldOptions {
            config: PioneerConfig::NOISY,
            layout: None,
            path: None,
        },
        damages: vec![Damage::Camera(12.0), Damage::None],
        protocol: Protocol {
            training: 300,
            before: 1000,
            after: 3000,
        },
    };
    let recover = run::<Recover>(&options, &Progress::hidden()).expect("it runs");
    let found = look(browser, "recover", &recover.page());
    fits("recover", &found);
    for found in &found {
        // Thirty actions before the damage, of the six hundred that are shown.
        assert_eq!(found["played"], "570 570", "{found}");
    }
}

#[test]
fn the_pages_of_brains_fit_a_telephone_and_a_desk_and_their_tables_sort() {
    let Some(browser) = browser() else {
        println!("skipped: there is no Chromium to look at pages with");
        return;
    };
    let folder = std::env::temp_dir().join(format!("host-sim-brains-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let brains = [
        ("agent", Raised::Agent(AgentConfig::FORAGER_LEVEL2)),
        ("mind", Raised::Mind),
    ];
    for (name, brain) in brains {
        let (file, page) = (folder.join(name), folder.join(format!("{name}.html")));
        train(&Training {
            seed: 3,
            world: WorldOptions::new(PioneerConfig::NOISY, None).expect("a world"),
            brain,
            actions: 3000,
            act: None,
            load: None,
            save: Some(file.clone()),
            log: vec![folder.join(format!("{name}.mcap"))],
        })
        .expect("it can be trained");
        inspect(&file, 5, Some(&page)).expect("it can be looked into");
        let page = fs::read_to_string(&page).expect("there is a page");
        for part in [
            "<svg class=\"graph\"",
            "perceived",
            "<h2>Health</h2>",
            "ingrip",
        ] {
            assert!(page.contains(part), "{name}: {part}");
        }
        assert!(
            !page
                .replace("http://www.w3.org/2000/svg", "")
                .contains("http")
        );
        fits_with_or_without_images(name, &look(browser, name, &page));
        let page = folder.join("replay.html");
        replayed(&folder.join(format!("{name}.mcap")), &page).expect("it can be replayed");
        let page = fs::read_to_string(&page).expect("there is a page");
        let found = look(browser, "replay", &page);
        for found in &found {
            assert_eq!(found["scroll"], found["width"], "{found}");
            assert_eq!(found["wide"], serde_json::json!([]), "{found}");
        }
    }
    fs::remove_dir_all(&folder).expect("the folder can be removed");
}
