"""Chapters 6.3 and 7.1.1: something breaks in mid-life, and nobody tells the robot."""

import gymnasium

import cla

TRAINING, WINDOW, WINDOWS = 20_000, 1000, 6
DAMAGES = (None, "camera:+12", "stuck:s3", "swap:turnl,turnr")


def course(damage):
    """Captures in every 1000 actions from the damage on, and how often the robot began to doubt."""
    env = gymnasium.make("cla/Pioneer-v0", damage=damage, damage_at=TRAINING)
    env.reset(seed=3)
    agent = cla.Agent.for_env(env, values={"ingrip": 10.0}, seed=3)
    agent.live(env, TRAINING)
    agent.act()
    before = agent.inside()["alarms"]
    lived = [agent.live(env, WINDOW).earned for _ in range(WINDOWS)]
    return lived, agent.inside()["alarms"] - before


print(f"captures in each {WINDOW} actions after {TRAINING} of training, one seed")
for damage in DAMAGES:
    lived, alarms = course(damage)
    print(f"  {damage or 'nothing broke':18} {' '.join(f'{it:4.0f}' for it in lived)}   {alarms} alarms")
print("`host-sim recover` judges this on many seeds, beside rivals")
