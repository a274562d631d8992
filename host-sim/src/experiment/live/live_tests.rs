//! Every learner in every world, shortly; what cannot live somewhere says why.

use serde_json::{Value, json};

use super::{Inhabitant, LEARNERS, Live, LiveOptions, Place, WORLDS};
use crate::experiment::plan;
use crate::experiment::record::judged_again;
use crate::experiment::recover::{Recover, RecoverOptions};
use crate::progress::Progress;
use crate::settings::{parse, take};

const SHORT: [u32; 3] = [100, 50, 100];

fn protocol([training, before, after]: [u32; 3]) -> Value {
    json!({"training": training, "before": before, "after": after})
}

#[test]
fn every_learner_lives_in_every_world_damaged_or_says_why_it_cannot() {
    for world in WORLDS {
        let place = Place::new(json!({ "name": world })).unwrap();
        let can = |name: &&&str| Inhabitant::new(json!({ "name": name }), &place, "agent").is_ok();
        let who: Vec<&str> = LEARNERS.iter().filter(can).copied().collect();
        let missing: Vec<&str> = LEARNERS.iter().filter(|it| !can(it)).copied().collect();
        match world {
            "pioneer" | "noise-free" => assert!(missing.is_empty()),
            "microworld" => assert_eq!(missing, ["servo", "told"]),
            _ => assert_eq!(missing, ["told"], "{world}"),
        }
        let last = place.actions().last().unwrap();
        let options = LiveOptions::new(
            vec![3],
            json!({
                "world": {"name": world},
                "agent": {"name": who[0]},
                "rivals": &who[1..],
                "damages": [format!("lost:{last}"), format!("stuck:{}", place.items()[0])],
                "protocol": protocol(SHORT),
            }),
        )
        .unwrap();
        let results = judged_again::<Live>(&options).unwrap();
        let rows = &results.summary.tables["lives"].rows;
        assert_eq!(rows.len(), 3 * who.len(), "{world}");
        assert!(results.summary.claims.len() > 4 * who.len());
        // What it was lived with is written, and read again as the same.
        let mut again = parse(&options.file().unwrap()).unwrap();
        again.as_object_mut().unwrap().remove("seeds");
        let again = LiveOptions::new(vec![3], again).unwrap();
        assert_eq!(json!(again), json!(options));
    }
}

#[test]
fn blinking_lost_and_sought_items_are_lived_with_by_brains_with_room() {
    let live = |world: Value, agent: &str| {
        let options = LiveOptions::new(
            vec![3],
            json!({"world": world, "agent": {"name": agent}, "protocol": protocol(SHORT)}),
        );
        let trials = plan::trials::<Live>(&options.unwrap(), &Progress::hidden()).unwrap();
        trials[0].0[0].twin.obtained[1].len()
    };
    for agent in ["mind", "forager-level2", "linear", "q", "random"] {
        for world in [
            json!({"name": "pioneer", "distractors": 20, "lost": 0.1, "lost_shows": "held"}),
            json!({"name": "vacuum", "distractors": 60}),
            json!({"name": "pioneer", "valued": "bump", "drop_out": 0}),
            json!({"name": "data/pomdp/shuttle_95.POMDP", "valued": "docked_LRV"}),
            json!({"name": "generated", "spec": 7}),
        ] {
            assert_eq!(live(world.clone(), agent), 4, "{agent} {world}");
        }
    }
}

#[test]
fn the_pioneers_rival_lives_the_life_that_it_lives_in_recover() {
    let mut options = LiveOptions::new(
        vec![5],
        json!({
            "agent": {"name": "sarsa-history"},
            "damages": ["camera:+12"],
            "protocol": protocol([400, 200, 1000]),
        }),
    )
    .unwrap();
    let live = plan::trials::<Live>(&options, &Progress::hidden()).unwrap();
    let world =
        crate::world::setting::WorldOptions::new(crate::world::config::PioneerConfig::NOISY, None);
    let recover = RecoverOptions {
        protocol: options.protocol,
        ..RecoverOptions::new(vec![5], world.unwrap(), &["camera:+12".into()]).unwrap()
    };
    let recover = plan::trials::<Recover>(&recover, &Progress::hidden()).unwrap();
    let who = crate::experiment::recover::Entrant::SarsaHistory;
    // It was tuned for a whole childhood, so both have the same.
    let (ours, theirs) = (&live[0].0[0].damaged[0], recover[0].course(0, who).unwrap());
    assert_eq!(ours.obtained[0], theirs.before);
    assert_eq!(ours.obtained[1], theirs.after);
    // What comes before the damage and the thousand actions after it, and those of the life without one,
    // stand in the table, too.
    let table = super::figures::windows(&options, &live).unwrap();
    let calm: u32 = ours.obtained[0].iter().sum();
    let damaged: u32 = ours.obtained[1].iter().sum();
    let twin = live[0].0[0].twin.all();
    let rows = [
        "seed,learner,damage,from,to,obtained".to_owned(),
        format!("5,sarsa-history,none,-200,0,{calm}"),
        format!("5,sarsa-history,none,0,1000,{twin}"),
        format!("5,sarsa-history,camera:+12,-200,0,{calm}"),
        format!("5,sarsa-history,camera:+12,0,1000,{damaged}"),
    ];
    assert_eq!(table.lines().collect::<Vec<_>>(), rows);
    // Another seed is another life.
    options.seeds = vec![6];
    let other = plan::trials::<Live>(&options, &Progress::hidden()).unwrap();
    assert_ne!(other, live);
}

#[test]
fn what_cannot_be_is_refused_in_one_sentence_that_says_where() {
    for (given, words) in [
        (json!({"wrold": {}}), "did you mean world?"),
        (json!({"world": 3}), "world is a table"),
        (json!({"world": {"name": "vacum"}}), "did you mean vacuum?"),
        (
            json!({"world": {"name": "no/such.POMDP"}}),
            "cannot read the world no/such.POMDP",
        ),
        (
            json!({"world": {"radios": 5}}),
            "did you mean world.radius?",
        ),
        (
            json!({"world": {"radius": 0.5}}),
            "radius in metres must be from 1 to 50",
        ),
        (json!({"world": {"radius": "wide"}}), "world.radius: "),
        (json!({"world": {"lost": 1.5}}), "world.lost"),
        (
            json!({"world": {"lost_shows": "on"}}),
            "world.lost_shows: unknown variant `on`",
        ),
        (json!({"world": {"distractors": 1000}}), "at most 121"),
        (
            json!({"world": {"valued": "s9"}}),
            "\"s9\" is no item of this world",
        ),
        (
            json!({"world": {"layout": "no/such"}}),
            "cannot read the layout",
        ),
        (
            json!({"world": {"name": "lake", "radius": 5}}),
            "world has no setting \"radius\"",
        ),
        (
            json!({"world": {"name": "microworld", "slip": 2}}),
            "world.slip",
        ),
        (
            json!({"agent": {"name": "sarsa-histroy"}}),
            "did you mean sarsa-history?",
        ),
        (
            json!({"agent": {"discuont": 0.9}}),
            "did you mean agent.discount?",
        ),
        (json!({"agent": {"discount": 1.0}}), "MindConfig::discount"),
        (
            json!({"agent": {"name": "q", "alpha": 0}}),
            "TabularConfig::alpha",
        ),
        (
            json!({"agent": {"name": "random", "alpha": 0}}),
            "agent has no setting",
        ),
        (
            json!({"agent": {"name": "forager", "adaptation": "all"}}),
            "agent.adaptation",
        ),
        (json!({"rivals": ["mind"]}), "mind cannot take part twice"),
        (json!({"rivals": [1]}), "rivals"),
        (json!({"damages": ["camera:+400"]}), "damages: camera takes"),
        // Thirteen each: what is written in full would not be read again.
        (
            json!({"damages": vec!["all"; 8]}),
            "damages are at most 100, not 104",
        ),
        (
            json!({"world": {"name": "lake"}, "damages": ["beam"]}),
            "damages: beam",
        ),
        (
            json!({"protocol": {"after": 0}}),
            "protocol.after is at least 1",
        ),
        (
            json!({"protocol": {"training": 10_000_001}}),
            "protocol.training is at most",
        ),
        (json!({"protocol": {"training": -1}}), "protocol.training: "),
    ] {
        let sentence = LiveOptions::new(vec![1], given.clone())
            .unwrap_err()
            .to_string();
        assert!(sentence.contains(words), "{given}: {sentence}");
        assert!(!sentence.contains('\n'), "{sentence}");
    }
    let mut given = json!({"agent": [1]});
    assert!(take(&mut given, "agent").is_err());
}
