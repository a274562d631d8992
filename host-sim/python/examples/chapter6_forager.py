"""Chapter 6: a robot that gathers specimens, what it knows, and what it does in a room that is new to it."""

import gymnasium

import cla

ROOM, NEW_ROOM, SEED = 1, 2, 1


def captures(agent, actions, seed):
    """Lives in the room of a seed; what it captured there."""
    env = gymnasium.make("cla/Pioneer-v0")
    env.reset(seed=seed)
    return agent.live(env, actions).earned


robot = gymnasium.make("cla/Pioneer-v0")
newborn = cla.Agent.for_env(robot, values={"ingrip": 10.0}, seed=SEED)
agent = cla.Agent.for_env(robot, values={"ingrip": 10.0}, seed=SEED)
print("captures in 3000 actions")
print(f"  of a newborn           {captures(newborn, 3000, NEW_ROOM):.0f}")
print(f"  while it trains, first {captures(agent, 3000, ROOM):.0f}")
captures(agent, 17_000, ROOM)
agent.act()
print(f"  after 20,000 actions   {captures(agent, 3000, NEW_ROOM):.0f}, in a room that is new to it")
for action in ("forward", "grip", "turnl"):
    known = [it for it in agent.schemas() if it["action"] == action]
    best = max(known, key=lambda it: it["value"])
    print(f"  {action} is worth most, {best['value']:.1f}, where {best['context'] or 'nothing is asked'}")
inside = agent.inside()
leading = max(inside["voices"], key=lambda voice: inside["voices"][voice][1])
print(f"{inside['samples']} samples, {inside['leaves']} leaves, {inside['bytes']} bytes; {leading} led most often")
