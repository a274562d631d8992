"""How long an online step takes through Python: MiniSom, the dense map, the binary map, a life.

Prints ratios of CPU time of the same run; nothing is asserted.  ``python speed.py [REPEATS]``.
"""

import sys
import time

import gymnasium
import numpy as np
from minisom import MiniSom

import cla

REPEATS = int(sys.argv[1]) if len(sys.argv) > 1 else 5
STEPS = 1000


def seconds(work, repeats=REPEATS):
    """The least CPU time of some repeats."""
    taken = []
    for _ in range(repeats):
        begun = time.process_time()
        work()
        taken.append(time.process_time() - begun)
    return min(taken)


def stimuli(features, on=10, samples=500):
    rng = np.random.default_rng(1)
    data = np.zeros((samples, features))
    for row in data:
        row[rng.choice(features, on, replace=False)] = 1
    return data


def main():
    for features, on in ((142, 10), (14, 4)):
        data = stimuli(features, on)
        arguments = {"sigma": 5, "learning_rate": 0.3, "random_seed": 1}
        maps = {
            "MiniSom": MiniSom(20, 20, features, **arguments),
            "cla.SOM": cla.SOM(20, 20, features, **arguments),
            "cla.SOM, binary": cla.SOM(20, 20, features, **arguments, binary=True),
        }
        theirs = None
        print(f"a step of train on 20 x 20 x {features}, {on} features on")
        for name, som in maps.items():
            step = seconds(lambda som=som: som.train(data, STEPS)) / STEPS
            theirs = theirs or step
            print(f"  {name:16} {1e6 * step:8.2f} us   1/{theirs / step:.1f} of MiniSom")

    print("an action of the one learner in cla/Pioneer-v0")
    actions = 20_000

    def live(block):
        env = gymnasium.make("cla/Pioneer-v0").unwrapped
        env.reset(seed=1)
        agent = cla.Agent.for_env(env, {"ingrip": 10.0}, seed=1)
        for _ in range(actions // block):
            agent.live(env, block)
        return agent.digest

    def steps():
        env = gymnasium.make("cla/Pioneer-v0").unwrapped
        env.reset(seed=1)
        agent = cla.Agent.for_env(env, {"ingrip": 10.0}, seed=1)
        for _ in range(actions):
            agent.learn_from(env.step(agent.choose(env.percept()).action))
        return agent.digest

    digests = {live(actions), live(100), steps()}
    for name, work in (
        (f"live(env, {actions})", lambda: live(actions)),
        ("live(env, 100)", lambda: live(100)),
        ("step by step", steps),
    ):
        print(f"  {name:18} {1e6 * seconds(work) / actions:8.2f} us")
    print(f"  the same life in all three: {len(digests) == 1}")


if __name__ == "__main__":
    main()
