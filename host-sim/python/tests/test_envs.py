"""The worlds as environments of Gymnasium."""

import subprocess
import sys
import warnings

import gymnasium
import numpy as np
import pytest
from conftest import LIVES, Digest
from gymnasium.utils.env_checker import check_env

import cla
from cla import envs

NAMES = ["Pioneer", "Microworld", "Shuttle", "Vacuum", "Lake", "Keys", "Generated"]
TWO_STATES = """discount: 0.9
values: reward
states: left right
actions: stay go
observations: dark light
T: stay
identity
T: go
0 1
1 0
O: *
1 0
0 1
R: go : right : * : * 1
"""


@pytest.mark.parametrize("name", NAMES)
def test_gymnasium_finds_nothing_to_complain_of(name):
    env = gymnasium.make(f"cla/{name}-v0")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped, skip_render_check=True)


@pytest.mark.parametrize("name", NAMES)
def test_stable_baselines_finds_nothing_to_complain_of(name, stable_baselines_check):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        stable_baselines_check(gymnasium.make(f"cla/{name}-v0").unwrapped, skip_render_check=True)


def test_stable_baselines_complains_of_an_environment_that_is_wrong(stable_baselines_check):
    class Wrong(envs.Lake):
        def step(self, action):
            return (*super().step(action)[:4], "no dictionary")

    with pytest.raises(AssertionError):
        stable_baselines_check(Wrong(), skip_render_check=True)


@pytest.mark.parametrize("world", LIVES["worlds"], ids=lambda it: it["env"] + str(it["options"]))
def test_a_seed_is_the_world_that_it_is_in_rust(world):
    env = gymnasium.make(world["env"], **world["options"]).unwrapped
    env.reset(seed=world["seed"])
    digest, earned, reflexes = Digest(), 0.0, 0
    for step in range(world["actions"]):
        digest.percept(env.percept())
        _, reward, terminated, truncated, info = env.step((step * step // 3) % len(env.actions))
        digest.percept(info["cla"]["felt"])
        earned += reward
        reflexes += len(info["cla"]["reflexes"])
        if (terminated or truncated) and env._episodic:
            env.reset()
    assert digest.hex() == world["digest"]
    assert reflexes == world["reflexes"]
    assert earned == pytest.approx(world["earned"], abs=1e-6)


def test_a_seed_makes_the_same_world_again_and_another_one_does_not():
    def sensed(seed):
        env = gymnasium.make("cla/Pioneer-v0")
        seen = [env.reset(seed=seed)[1]["x"]]
        for action in [0, 2, 0, 3] * 20:
            info = env.step(action)[4]
            seen += [info["x"], info["heading"]]
        return seen

    assert sensed(1) == sensed(1)
    assert sensed(1) != sensed(2)


def test_worlds_that_are_reset_without_a_seed_differ_and_are_decided_by_the_last_one():
    def rooms(seed):
        env = gymnasium.make("cla/Pioneer-v0")
        env.reset(seed=seed)
        return [env.reset()[1]["heading"] for _ in range(3)]

    assert rooms(5) == rooms(5)
    assert len(set(rooms(5))) == 3


def test_an_episode_on_the_lake_ends_in_a_hole_or_for_want_of_time():
    env = gymnasium.make("cla/Lake-v0")
    env.reset(seed=1)
    ends = set()
    for step in range(20_000):
        _, reward, terminated, truncated, info = env.step(step % 4 if step % 1000 < 500 else 0)
        if terminated:
            ends.add(("goal" if reward else "hole"))
            assert info["field"] in (5, 7, 11, 12, 15)
        if truncated:
            ends.add("time")
            assert info["left"] == 0
        if terminated or truncated:
            observation, _ = env.reset()
            assert observation[0] == 1
    assert {"hole", "time"} <= ends


def test_the_pose_is_beside_what_is_perceived():
    env = gymnasium.make("cla/Pioneer-v0", step_noise=0, turn_noise=0, drop_out=0)
    _, info = env.reset(seed=4)
    before = info["heading"]
    _, _, _, _, info = env.step(2)
    turned = (info["heading"] - before) % (2 * np.pi)
    assert turned == pytest.approx(np.radians(5), abs=1e-9)
    assert info["actions"] == 1


def test_what_is_broken_from_the_beginning_and_in_mid_life():
    stuck = gymnasium.make("cla/Pioneer-v0", damage="stuck:s1").unwrapped
    stuck.reset(seed=1)
    assert stuck.percept()[0] == 1
    later = gymnasium.make("cla/Pioneer-v0", damage="stuck:s1", damage_at=10).unwrapped
    later.reset(seed=1)
    seen = [later.step(2)[0][0] for _ in range(10)]
    assert seen[-1] == 1 and 0 in seen[:-1]
    later.reset(seed=1)
    assert later.percept()[0] == 0
    later.suffer("stuck:s1")
    assert later.percept()[0] == 1
    later.suffer("dead:s1")
    assert later.percept()[0] == 0


def test_a_world_of_a_file(tmp_path):
    path = tmp_path / "two.POMDP"
    path.write_text(TWO_STATES)
    env = gymnasium.make("cla/Pomdp-v0", file=path).unwrapped
    assert env.items == ("dark", "light") and env.actions == ("stay", "go")
    env.reset(seed=1)
    rewards = [env.step(1)[1] for _ in range(10)]
    assert sorted(rewards) == [0.0] * 5 + [1.0] * 5
    check_env(env, skip_render_check=True)
    path.write_text(TWO_STATES.replace("O: *\n1 0", "O: *\n0.5 0"))
    with pytest.raises(ValueError, match="line"):
        gymnasium.make("cla/Pomdp-v0", file=path)
    path.write_text("states: 999999999\nactions: 9\nobservations: 9\n")
    with pytest.raises(ValueError, match="line"):
        gymnasium.make("cla/Pomdp-v0", file=path)
    path.write_bytes(b"\xff\xfe\x00states")
    with pytest.raises(ValueError, match="no text"):
        gymnasium.make("cla/Pomdp-v0", file=path)
    for file in (3, None, tmp_path / "nobody.POMDP"):
        with pytest.raises((ValueError, OSError)):
            gymnasium.make("cla/Pomdp-v0", file=file)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"radius": float("nan")}, "radius is finite"),
        ({"radius": -1}, "radius"),
        ({"specimens": 2.5}, "specimens"),
        ({"colour": 1}, "no option .*colour"),
        ({"damage": "dead:s9"}, "s9"),
        ({"damage": "broken"}, "broken"),
        ({"damage": 3}, "damage"),
        ({"damage": "dead:s1", "damage_at": -1}, "damage_at"),
        ({"damage": "dead:s1", "damage_at": 0.5}, "damage_at"),
        ({"turn": "five"}, "turn"),
    ],
)
def test_an_impossible_room_is_refused_in_a_sentence(arguments, words):
    with pytest.raises(ValueError, match=words) as refused:
        gymnasium.make("cla/Pioneer-v0", **arguments)
    assert "\n" not in str(refused.value)


def test_a_damage_that_this_world_cannot_have_is_refused_and_changes_nothing():
    with pytest.raises(ValueError):
        envs.Lake(damage="camera:+12")
    env = envs.Lake()
    env.reset(seed=1)
    for damage in ("camera:+12", "dead:s1", "", 3, None):
        with pytest.raises(ValueError):
            env.suffer(damage)
    assert env.step(1)[4]["actions"] == 1


def test_a_damage_of_later_that_cannot_be_is_refused_at_once():
    for world, damage in [(envs.Lake, "camera:+12"), (envs.Shuttle, "camera:+5"), (envs.Pioneer, "dead:s9")]:
        with pytest.raises(ValueError):
            world(damage=damage, damage_at=20_000)


def test_a_world_suffers_often_and_the_interpreter_lives_on():
    """Each damage lies around those before it; without an end to that the stack would not last."""
    program = """
import cla
env = cla.envs.Pioneer()
env.reset(seed=1)
for time in range(200_000):
    try:
        env.suffer("camera:+1")
    except ValueError as refused:
        assert "at most 32 damages" in str(refused)
        break
env.step(0)
env.reset(seed=1)
env.suffer("dead:s1")
print(time)
"""
    ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stdout) == (0, "32\n"), ran.stderr


def test_what_breaks_in_mid_life_breaks_in_the_middle_of_a_block_and_across_episodes():
    env = envs.Lake(damage="lost:up", damage_at=150)
    env.reset(seed=1)
    agent = cla.Agent.for_env(env, seed=1)
    other_env = envs.Lake(damage="lost:up", damage_at=150)
    other_env.reset(seed=1)
    other = cla.Agent.for_env(other_env, seed=1)
    agent.live(env, 400)
    for actions in (149, 1, 1, 249):
        other.live(other_env, actions)
    assert agent.digest == other.digest and agent.image() == other.image()
    whole = envs.Lake()
    whole.reset(seed=1)
    unharmed = cla.Agent.for_env(whole, seed=1)
    unharmed.live(whole, 150)
    again = cla.Agent.for_env(whole, seed=1)
    broken = envs.Lake(damage="lost:up", damage_at=150)
    broken.reset(seed=1)
    again.live(broken, 150)
    assert unharmed.digest == again.digest
    unharmed.live(whole, 250)
    assert unharmed.digest != agent.digest


@pytest.mark.parametrize("action", [-1, 6, 2.5, "forward", None, np.float32(1)])
def test_an_action_that_is_none_is_refused(action):
    env = envs.Pioneer()
    env.reset(seed=1)
    with pytest.raises(ValueError, match="action"):
        env.step(action)
    assert env.step(np.int64(2))[4]["actions"] == 1


@pytest.mark.parametrize("seed", [-1, 2**64, 1.5, "one"])
def test_a_seed_that_is_none_is_refused(seed):
    with pytest.raises(ValueError, match="seed"):
        envs.Lake().reset(seed=seed)


def test_nothing_is_done_before_the_first_reset_or_after_the_end():
    env = envs.Pioneer()
    with pytest.raises(ValueError, match="reset"):
        env.step(0)
    env.reset(seed=1)
    env.close()
    for use in (lambda: env.step(0), env.reset, env.percept, lambda: env.suffer("dead:s1")):
        with pytest.raises(ValueError, match="closed"):
            use()
    agent = cla.Agent.for_env(env)
    with pytest.raises(ValueError, match="closed"):
        agent.live(env, 10)
    env.close()
