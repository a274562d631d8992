"""The one learner."""

import copy
import pickle
import subprocess
import sys
import zlib

import gymnasium
import numpy as np
import pytest
from conftest import LIVES

import cla

ITEMS = ["light", "lamp"]
ACTIONS = ["stay", "go"]


def moth(**arguments):
    return cla.Agent(ITEMS, ACTIONS, {"lamp": 1.0}, seed=1, **arguments)


def trained(steps=400, **arguments):
    """Going when there is light leads to the lamp."""
    agent = moth(**arguments)
    for step in range(steps):
        light = step % 2 == 0
        choice = agent.choose([light, False])
        agent.learn([not light, light and choice.action == 1])
    return agent


def life(entry):
    env = gymnasium.make(entry["env"], damage=entry["damage"], damage_at=entry["damage_at"]).unwrapped
    values = {entry["value"]: 10.0} if entry["value"] else None
    agent = cla.Agent.for_env(env, values, profile=entry["profile"], seed=entry["seed"])
    env.reset(seed=entry["seed"])
    return env, agent


LIVED = pytest.mark.parametrize(
    "entry", LIVES["lives"], ids=lambda it: f"{it['env']} {it['profile']} {it['damage']}"
)


@LIVED
def test_a_life_is_the_life_that_it_is_in_rust(entry):
    env, agent = life(entry)
    first = agent.live(env, entry["actions"] // 3)
    second = agent.live(env, entry["actions"] - first.actions)
    assert agent.digest == entry["digest"]
    assert first.earned + second.earned == pytest.approx(entry["earned"])
    assert first.episodes + second.episodes == entry["episodes"]
    if entry["image"] is not None:
        image = agent.image()
        assert f"{zlib.crc32(image[:-4]):08x}" == image[-4:][::-1].hex() == entry["image"]


@LIVED
def test_a_life_step_by_step_is_the_same_life(entry):
    env, agent = life(entry)
    for _ in range(entry["actions"]):
        step = env.step(agent.choose(env.percept()).action)
        agent.learn_from(step)
        if step[2] or step[3]:
            env.reset()
    assert agent.digest == entry["digest"]


def test_a_life_in_a_generated_world_is_the_same_in_blocks_and_step_by_step():
    def born():
        env = gymnasium.make("cla/Generated-v0", world=5).unwrapped
        env.reset(seed=2)
        return env, cla.Agent.for_env(env, seed=2)

    (env, one), (other_env, other) = born(), born()
    lived = one.live(env, 2000)
    assert lived.actions == 2000 and lived.earned > 0
    for _ in range(2000):
        other.learn_from(other_env.step(other.choose(other_env.percept()).action))
    assert one.digest == other.digest and one.image() == other.image()


def test_a_moth_learns_to_go_where_there_is_light():
    agent = trained()
    assert agent.choose([1, 0]).action == 1


def test_it_lives_in_any_environment_with_binary_items():
    class Corridor(gymnasium.Env):
        """Five places; the prize is at the end."""

        observation_space = gymnasium.spaces.MultiBinary(5)
        action_space = gymnasium.spaces.Discrete(2)

        def reset(self, *, seed=None, options=None):
            super().reset(seed=seed)
            self.at = 0
            return self.seen(), {}

        def seen(self):
            return np.eye(5, dtype=np.int8)[self.at]

        def step(self, action):
            self.at = max(0, self.at + (1 if action else -1))
            return self.seen(), float(self.at == 4), self.at == 4, False, {}

    agent = cla.Agent([f"p{at}" for at in range(5)], ["back", "on"], seed=2)
    agent.live(Corridor(), 1000)
    agent.act()
    lived = agent.live(Corridor(), 400)
    # Four actions an episode at best.
    assert lived.episodes > 80 and lived.earned == lived.episodes


class Told(gymnasium.Wrapper):
    """Counts what comes through and pays twice."""

    def __init__(self, env):
        super().__init__(env)
        self.steps = self.resets = 0

    def reset(self, **arguments):
        self.resets += 1
        return super().reset(**arguments)

    def step(self, action):
        self.steps += 1
        observation, reward, *rest = super().step(action)
        return (observation, 2 * reward, *rest)


def test_a_life_goes_through_whatever_lies_around_a_world():
    env = Told(gymnasium.make("cla/Shuttle-v0"))
    env.reset(seed=1)
    lived = cla.Agent.for_env(env, seed=1).live(env, 50)
    assert (env.steps, env.resets, lived.actions) == (50, 2, 50)
    bare = gymnasium.make("cla/Shuttle-v0")
    bare.reset(seed=1)
    assert bare.unwrapped is not bare
    before = bare.unwrapped._world
    cla.Agent.for_env(bare, seed=1).live(bare, 50)
    # Nothing of ours but the world: led in Rust, and not begun anew.
    assert bare.unwrapped._world is before

    class Own(cla.envs.Lake):
        done = 0

        def step(self, action):
            self.done += 1
            return super().step(action)

    own = Own()
    cla.Agent.for_env(own, seed=1).live(own, 30)
    assert own.done == 30


class Begun(gymnasium.Wrapper):
    """Begins with one seed, whoever asks; leaves all else as it comes."""

    def reset(self, **arguments):
        return super().reset(seed=5)


@pytest.mark.parametrize("values", [{"ingrip": 10.0}, None])
def test_a_wrapper_that_changes_nothing_leaves_the_life_of_the_bare_world(values):
    """A specimen is felt before the gripper has closed by reflex, and the observation shows what came after."""
    bare = gymnasium.make("cla/Pioneer-v0")
    bare.reset(seed=5)
    one, other = (cla.Agent.for_env(bare, values, seed=5) for _ in range(2))
    lived = one.live(bare, 3000)
    around = Begun(gymnasium.make("cla/Pioneer-v0", max_episode_steps=10_000))
    assert other.live(around, 3000) == lived and lived.earned > 10
    assert other.digest == one.digest and other.image() == one.image()
    assert around.unwrapped._world.facts() == bare.unwrapped._world.facts()
    worth = [max(row["value"] for row in it.schemas()) for it in (one, other)]
    assert worth[0] == worth[1] > 0.05


class Inverted(gymnasium.ObservationWrapper):
    def observation(self, observation):
        return 1 - observation


class Hidden(gymnasium.ObservationWrapper):
    """What is worth having cannot be seen."""

    def observation(self, observation):
        seen = observation.copy()
        seen[-1] = 0
        return seen


class Driven(gymnasium.ActionWrapper):
    """Fewer actions, in another order."""

    def __init__(self, env):
        super().__init__(env)
        self.action_space = gymnasium.spaces.Discrete(4)

    def action(self, action):
        return 3 - action


@pytest.mark.parametrize("wrapper", [Inverted, Hidden, Driven])
def test_what_a_wrapper_shows_is_all_that_is_learned_from(wrapper):
    shown, learned = [], []
    env = wrapper(gymnasium.make("cla/Pioneer-v0"))
    items = env.unwrapped.items
    agent = cla.Agent(items, list("abcdef")[: env.action_space.n], {items[-1]: 10.0}, seed=1)
    step, learn = env.step, agent.learn
    env.step = lambda action: shown.append(step(action)) or shown[-1]
    agent.learn = lambda seen, reward=0.0: learned.append(seen) or learn(seen, reward)
    agent.learn_from = agent._learn_from = None
    agent.live(env, 300)
    assert np.array_equal(learned, [it[0] for it in shown]) and len(learned) == 300


def test_the_end_of_time_that_a_wrapper_sets_ends_an_episode():
    env = gymnasium.make("cla/Pioneer-v0", max_episode_steps=20)
    agent = cla.Agent.for_env(env, {"ingrip": 10.0}, seed=1)
    ended = []
    agent.interrupt = lambda: ended.append(True)
    assert agent.live(env, 100).episodes == 5 == len(ended)


def test_a_life_does_not_follow_from_the_one_before_a_reset():
    env, ended = gymnasium.make("cla/Pioneer-v0"), []
    agent = cla.Agent.for_env(env, {"ingrip": 10.0}, seed=1)
    agent.interrupt = lambda: ended.append(True)
    for seed, interrupted in [(1, 0), (2, 1), (None, 1)]:
        if seed is not None:
            env.reset(seed=seed)
        agent.live(env, 10)
        assert len(ended) == interrupted


def test_a_specimen_pays_who_is_paid_although_a_reflex_has_taken_it():
    """The gripper closes by reflex, so the reward comes with one."""
    earned = {}
    for block in (1, 3000):
        env = gymnasium.make("cla/Pioneer-v0").unwrapped
        env.reset(seed=5)
        agent = cla.Agent.for_env(env, seed=5)
        life = [agent.live(env, block) for _ in range(3000 // block)]
        earned[block] = (sum(it.earned for it in life), agent.digest, agent.image())
    assert earned[1] == earned[3000] and earned[1][0] > 10
    worth = max(row["value"] for row in agent.schemas())
    assert worth > 0.05

    env = gymnasium.make("cla/Pioneer-v0").unwrapped
    env.reset(seed=5)
    other = cla.Agent.for_env(env, seed=5)
    brought = sum(other.learn_from(env.step(other.choose(env.percept()).action)) for _ in range(3000))
    assert brought == earned[3000][0] and other.digest == agent.digest


@pytest.mark.parametrize("profile", ["standard", "small", "planner"])
def test_a_mind_of_any_size_is_born_and_loaded_in_a_thread_with_little_stack(profile):
    program = f"""
import threading
import cla
def make():
    one = cla.Agent([f"i{{at}}" for at in range(112)], [f"a{{at}}" for at in range(24)], profile={profile!r})
    one.choose([0] * 112)
    one.learn([1] * 112)
    one.load(one.image())
    done.append(one)
done = []
threading.stack_size(192 * 1024)
thread = threading.Thread(target=make)
thread.start()
thread.join()
print(len(done))
"""
    ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stdout) == (0, "1\n"), ran.stderr


@pytest.mark.parametrize("profile", ["standard", "small", "planner"])
def test_a_pickled_agent_goes_on_as_if_nothing_had_been(profile):
    one = trained(profile=profile)
    for other in (pickle.loads(pickle.dumps(one)), copy.deepcopy(one)):
        assert other.digest == one.digest and other.image() == one.image()
        assert other.schemas() == one.schemas() and other.items == one.items
    other = pickle.loads(pickle.dumps(one))
    for step in range(50):
        percept = [step % 2, step % 3 == 0]
        assert one.choose(percept) == other.choose(percept)
        assert one.learn(percept) == other.learn(percept)
    assert one.digest == other.digest


@pytest.mark.parametrize(
    ("head", "words"),
    [(b"CLAPY\x01\x00\x00", "of version 1: those of version 2"), (b"CLA", "of no version"), (b"", "of no version")],
)
def test_a_pickle_of_another_version_is_refused_in_a_sentence(head, words):
    agent = trained()
    state = agent.__getstate__()
    state["image"] = head + state["image"][8:]
    other = cla.Agent.__new__(cla.Agent)
    with pytest.raises(ValueError, match=words) as refused:
        other.__setstate__(state)
    assert "\n" not in str(refused.value) and not other.__dict__
    # What version 1 kept had other names for values and configuration.
    old = {name: it for name, it in state.items() if name not in ("_given", "_worth")}
    with pytest.raises(ValueError, match=words):
        other.__setstate__({**old, "image": head})


def test_a_saved_agent_is_recalled_and_a_wrong_file_leaves_it_as_it_was(tmp_path):
    agent, path = trained(), tmp_path / "moth.brain"
    agent.save(path)
    assert [it.name for it in tmp_path.iterdir()] == ["moth.brain"]
    other = moth()
    other.load(path)
    assert other.image() == agent.image() == path.read_bytes()
    image = path.read_bytes()
    wrong = [
        (image[:-1], "missing|behind|damaged"),
        (image + b"x", "behind"),
        (image[:200] + b"\0\1\2" + image[203:], "damaged|missing"),
        (b"", "image"),
        (b"nothing like it", "missing"),
        (b"nothing like it" * 100, "no image"),
        (moth(profile="small").image(), "samples|stretches"),
        (cla.Agent(["light", "lump"], ACTIONS, seed=1).image(), "items have other names"),
        (cla.Agent(ITEMS, ["stay", "fly"], seed=1).image(), "actions have other names"),
        (cla.Agent([f"i{it}" for it in range(40)], ACTIONS).image(), "items|words"),
    ]
    for data, words in wrong:
        with pytest.raises(ValueError, match=words) as refused:
            other.load(data)
        assert "\n" not in str(refused.value)
        assert other.image() == image
    for path in (3, None, ["moth.brain"]):
        with pytest.raises(ValueError, match="path of a file"):
            other.load(path)
        with pytest.raises(ValueError, match="path of a file"):
            other.save(path)
    with pytest.raises(OSError):
        other.load(tmp_path / "nobody.brain")
    with pytest.raises(OSError):
        agent.save(tmp_path / "no folder" / "moth.brain")


def test_a_loaded_life_has_the_values_and_the_configuration_that_it_was_born_with():
    other = cla.Agent(ITEMS, ACTIONS, {"light": 2.0}, seed=4, exploring=0.3, doubt_lasts=900)
    agent = moth()
    assert agent.values == (0.0, 1.0) and agent.config["exploring"] == 0.1
    agent.load(other.image())
    assert agent.values == other.values == (2.0, 0.0)
    assert agent.config == other.config and agent.config["doubt_lasts"] == 900
    assert agent.seed is None and other.seed == 4
    assert not agent._is_paid(None)
    agent.load(cla.Agent(ITEMS, ACTIONS, seed=1).image())
    assert agent.values == (0.0, 0.0) and agent._is_paid(None)
    kept = pickle.loads(pickle.dumps(agent))
    assert kept.values == agent.values and kept.config == agent.config and kept.image() == agent.image()


def test_settings_are_those_of_the_configuration_and_nothing_else():
    agent = moth(doubting="never", heard=["habits", "model"], block=25.0, discount=1e-3)
    assert agent.config["doubting"] == "never" and agent.config["heard"] == ["habits", "model"]
    assert agent.config["block"] == 25 and agent.config["discount"] == 1e-3
    assert cla.Agent(ITEMS, ACTIONS, **agent.config).config == agent.config


def test_schemas_make_a_table():
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(trained().schemas())
    assert set(table["action"]) == set(ACTIONS)
    assert {"context", "value", "reliability"} <= set(table.columns)
    assert table["value"].notna().all()
    planner = pandas.DataFrame(trained(profile="planner").schemas())
    going = planner[(planner["action"] == "go") & (planner["result"] == "+lamp")]
    assert list(going["context"]) == ["+light"]
    assert (planner["reliability"].dropna() <= 1).all()


def test_a_planner_has_schemas_pursues_goals_and_says_why():
    agent = trained(profile="planner")
    agent.interrupt()
    agent.act()
    rows = agent.schemas()
    assert any(it["action"] == "go" and it["result"] == "+lamp" for it in rows)
    assert all(0.0 <= it["reliability"] <= 1.0 for it in rows if it["activations"])
    agent.idle(100_000)
    assert agent.pursue("+lamp", [1, 0], limit=5) == "underway"
    agent.idle(10_000)
    assert agent.way([1, 0]) == 1
    choice = agent.choose([1, 0])
    assert (choice.action, choice.motive) == (1, "goal")
    why = agent.explain()
    assert why["schema"].startswith("+light") and "/go/" in why["schema"] and "+lamp" in why["schema"]
    agent.learn([0, 1])
    assert agent.pursuit == "reached" and agent.explain() is None
    agent.pursue({"light": True, "lamp": False}, [0, 0])
    agent.give_up()
    assert agent.pursuit == "nothing"
    for goal, words in [("", "at least"), ("+lump", "lump"), ("lamp", "written"), ({}, "at least")]:
        with pytest.raises(ValueError, match=words):
            agent.pursue(goal, [0, 0])


def test_who_has_no_reason_pursues_nothing():
    with pytest.raises(ValueError, match="no reason"):
        trained().pursue("+lamp", [1, 0])


def test_a_choice_among_some_actions():
    agent = trained()
    assert {agent.choose([1, 0], allowed=[0]).action for _ in range(20)} == {0}
    with pytest.raises(ValueError, match="no action is allowed"):
        agent.choose([1, 0], allowed=[])
    with pytest.raises(ValueError, match="allowed action"):
        agent.choose([1, 0], allowed=[2])


def test_percepts_of_any_type_are_the_same_percept():
    seen = [
        [True, False],
        (1, 0),
        np.array([1, 0], dtype=np.int64),
        np.array([1, 0], dtype=np.uint8),
        np.array([1.0, 0.0], dtype=np.float32),
        np.array([1, 9, 0, 9], dtype=np.int8)[::2],
    ]
    digests = set()
    for percept in seen:
        agent = moth()
        agent.choose(percept)
        agent.learn(percept, np.float64(0.5))
        digests.add(agent.digest)
    assert len(digests) == 1
    agent = moth()
    agent.choose([-1, 0])
    assert agent.digest not in digests


@pytest.mark.parametrize(
    ("percept", "words"),
    [
        ([1], "shape"),
        ([1, 0, 0], "shape"),
        ([[1, 0]], "shape"),
        (1, "shape"),
        (None, "shape"),
        (["on", "off"], "numbers"),
        ([1, 2], "item 1 .lamp."),
        (np.array([1, 3], dtype=np.int8), "item 1"),
        ([float("nan"), 0], "item 0 .light."),
        ([0.5, 0], "item 0"),
        ([1j, 0], "numbers"),
    ],
)
def test_a_percept_that_is_none_is_refused_in_a_sentence(percept, words):
    agent = moth()
    before = agent.image()
    with pytest.raises(ValueError, match=words):
        agent.choose(percept)
    assert agent.image() == before


@pytest.mark.parametrize("reward", [float("nan"), float("inf"), 1e9, "much", None])
def test_a_reward_that_is_none_is_refused(reward):
    agent = moth()
    agent.choose([1, 0])
    with pytest.raises(ValueError):
        agent.learn([1, 0], reward)
    assert agent.learn([0, 1], 0.5) == 1.5


def test_what_comes_in_the_wrong_order_is_refused():
    agent = moth()
    with pytest.raises(ValueError, match="nothing was chosen"):
        agent.learn([1, 0])
    for action, words in [(2, "an action is from 0 to 1"), (-1, "from 0 to 1"), (0.5, "whole"), ("go", "whole")]:
        with pytest.raises(ValueError, match=words):
            agent.observe([1, 0], action, [1, 0])
    for before, after in [([1], [1, 0]), ([1, 0], [1, 0, 0]), ([1, 0], [float("nan"), 0]), (["a", "b"], [1, 0])]:
        with pytest.raises(ValueError):
            agent.observe(before, 0, after)
    for percept in ([1, 0, 1], [2, 0], [float("nan"), 0], None):
        agent.choose([1, 0])
        with pytest.raises(ValueError):
            agent.learn(percept)
    agent.interrupt()
    for units in (-1, 0.5, "many", 2**32):
        with pytest.raises(ValueError, match="units"):
            agent.idle(units)
    env = gymnasium.make("cla/Lake-v0")
    for actions in (-1, 0.5, None, 2**41):
        with pytest.raises(ValueError, match="actions"):
            cla.Agent.for_env(env).live(env, actions)
    assert agent.observe([1, 0], 1, [0, 1]) == 1.0


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"items": []}, "items"),
        ({"items": [f"i{at}" for at in range(113)]}, "112"),
        ({"items": "light"}, "list of names"),
        ({"items": ["a", "a"]}, "twice"),
        ({"items": ["a+b"]}, "no \\+"),
        ({"items": ["a", 3]}, "items.1."),
        ({"actions": [f"a{at}" for at in range(25)]}, "24"),
        ({"values": {"lump": 1}}, "lump"),
        ({"values": [1.0]}, "2 values"),
        ({"values": [1.0, float("nan")]}, "lamp"),
        ({"values": [1.0, 1e9]}, "reward"),
        ({"profile": "huge"}, "standard, small, planner"),
        ({"seed": -1}, "seed"),
        ({"seed": 1.5}, "seed"),
        ({"exploring": 2.0}, "exploring"),
        ({"exploring": float("nan")}, "exploring"),
        ({"block": 0.5}, "block"),
        ({"exploration": 0.1}, "did you mean config.exploring"),
        ({"block": -1}, "block"),
        ({"block": 2**16}, "block"),
        ({"doubting": "often"}, "doubting"),
        ({"heard": ["voices"]}, "heard"),
        ({"discount": "much"}, "discount"),
        ({"discount": [0.5]}, "discount"),
        ({"profile": 3}, "profile"),
    ],
)
def test_an_impossible_agent_is_refused_in_a_sentence(arguments, words):
    with pytest.raises(ValueError, match=words) as refused:
        cla.Agent(**{"items": ITEMS, "actions": ACTIONS, **arguments})
    assert "\n" not in str(refused.value)


def test_an_agent_of_another_robot_does_not_live_here():
    env = gymnasium.make("cla/Lake-v0")
    with pytest.raises(ValueError, match="16 items"):
        moth().live(env, 10)
    with pytest.raises(ValueError, match="does not name"):
        cla.Agent.for_env(gymnasium.make("CartPole-v1"))


@pytest.mark.parametrize(
    ("items", "actions", "form"), [(7, 6, (7, 6)), (7, 7, (32, 8)), (50, 3, (64, 12)), (112, 24, (112, 24))]
)
def test_a_robot_gets_the_smallest_form_that_holds_it(items, actions, form):
    agent = cla.Agent([f"i{at}" for at in range(items)], [f"a{at}" for at in range(actions)], seed=1)
    assert agent.form == form
    chosen = {agent.choose([0] * items).action for _ in range(20)}
    assert max(chosen) < actions


def test_the_sizes_of_the_profiles():
    def size(profile):
        return cla.Agent([f"i{at}" for at in range(7)], [f"a{at}" for at in range(6)], profile=profile).inside()["bytes"]

    assert 240_000 < size("standard") < 265_000
    assert size("small") < 65_536 < size("planner")
    assert set(cla.PROFILES) == {"standard", "small", "planner"}
