"""Chapter 5: an eye, a hand and a ball; schemas from random actions, and goals that are reached by them."""

import gymnasium
import numpy as np

import cla

ACTIONS = 6_000
env = gymnasium.make("cla/Microworld-v0").unwrapped
env.reset(seed=1)
agent = cla.Agent.for_env(env, values={"hgr": 10.0}, profile="planner", seed=1)

rng = np.random.default_rng(1)
before = env.percept()
for action in rng.integers(len(env.actions), size=ACTIONS):
    env.step(action)
    after = env.percept()
    agent.observe(before, action, after)
    before = after
agent.interrupt()
agent.act()

schemas = [it for it in agent.schemas() if it["result"].startswith("+") and (it["activations"] or 0) >= 10]
schemas.sort(key=lambda it: (-it["reliability"], -it["activations"]))
print(f"{len(agent.schemas())} schemas after {ACTIONS} random actions; the most tried of the reliable ones:")
for it in schemas[:8]:
    print(f"  {it['context']}/{it['action']}/{it['result']}   {it['successes']} of {it['activations']}")

print("goals, each from wherever the last one ended, within 20 actions:")
for goal in ("+hp11", "+hp33", "+vp22", "+vp13", "+hgr", "+taste1"):
    agent.pursue(goal, env.percept(), limit=20)
    agent.idle(100_000)
    way, done, why = agent.way(env.percept()), 0, ""
    while agent.pursuit == "underway":
        choice = agent.choose(env.percept())
        why = why or agent.explain()["schema"]
        agent.learn_from(env.step(choice.action))
        done += 1
    print(f"  {goal:8} {agent.pursuit} after {done}, foreseen were {way}; first {why}")
