"""Chapter 4: launching events, and why a direct one is special.

A ball comes, another leaves: at once and where the first one stopped (direct), later (delay), from a
distance (gap), or both.  Position and Movement see cells and speeds, the Top layer reads both.  This is
the experiment in little, layer by layer; ``host-sim causal`` is the whole, with seeds and controls.
"""

import numpy as np

import cla

CELLS, MIDDLE, SPEED = 20, 10, 3
KINDS = {"direct": (0, 0), "delay": (3, 0), "gap": (0, 4), "delay and gap": (3, 4)}
SIGMAS = {"position": 0.5, "movement": 0.7, "top": 0.5}


def event(delay, gap):
    """Places of both balls at every step."""
    first = list(range(1, MIDDLE, SPEED))
    stop, start = first[-1], min(first[-1] + 1 + gap, CELLS - 1)
    second = list(range(start, CELLS, SPEED))
    places = [(at, start) for at in first] + [(stop, start)] * delay
    places += [(stop, at) for at in second[1:]]
    return [places[0], *places, places[-1]]


def stimuli(kind):
    """What Position (20 cells) and Movement (three times two bars of 10) see at every step."""
    places = event(*KINDS[kind])
    speeds = [(0, 0)] + [(b[0] - a[0], b[1] - a[1]) for a, b in zip(places, places[1:])]
    positions, movements, bars = [], [], [np.zeros(20)] * 2
    for place, speed in zip(places, speeds):
        cells = np.zeros(CELLS)
        cells[list(place)] = 1
        bar = np.zeros((2, 10))
        for ball, level in enumerate(speed):
            bar[ball, 1 : level + 1] = 1
            bar[ball, 0] = level == 0
        bars = [*bars[-2:], bar.ravel()]
        positions.append(cells)
        movements.append(np.concatenate(bars))
    return np.array(positions), np.array(movements)


def activations(som, seen, sigma):
    return np.array([np.exp(-(som.activate(it).astype(float) ** 2) / (2 * sigma**2)).ravel() for it in seen])


def run(seed):
    rng = np.random.default_rng(seed)
    kinds = rng.choice(list(KINDS), size=4000, p=[0.85, 0.05, 0.05, 0.05])
    seen = {kind: stimuli(kind) for kind in KINDS}
    layers = {
        "position": cla.SOM(12, 12, 20, sigma=6, random_seed=seed),
        "movement": cla.SOM(6, 6, 60, sigma=3, random_seed=seed + 1),
        "top": cla.SOM(8, 8, 180, sigma=4, random_seed=seed + 2),
    }
    for at, name in enumerate(("position", "movement")):
        data = np.concatenate([seen[kind][at] for kind in kinds])
        layers[name].train(data, len(data))
    joined = {
        kind: np.hstack(
            [activations(layers[name], seen[kind][at], SIGMAS[name]) for at, name in enumerate(("position", "movement"))]
        )
        for kind in KINDS
    }
    data = np.concatenate([joined[kind] for kind in kinds])
    layers["top"].train(data, len(data))
    # The activation composite: the sum of the layer's activations over an event.
    return {kind: activations(layers["top"], joined[kind], SIGMAS["top"]).sum(axis=0) for kind in KINDS}


def apart(composites, one, other):
    return float(np.abs(composites[one] - composites[other]).sum())


rows = []
for seed in range(3):
    it = run(10 * seed)
    rows.append([apart(it, "direct", "delay and gap"), apart(it, "direct", "gap"), apart(it, "delay", "gap")])
names = ("direct - delay and gap", "direct - gap", "delay - gap")
print("differences of composites in the Top layer, three seeds (book: 9.66, 8.20, 5.38)")
for name, values in zip(names, np.transpose(rows)):
    print(f"  {name:23} {values.mean():6.2f}   {np.round(values, 2)}")
first, second = np.mean(rows, axis=0)[:2] / np.mean(rows, axis=0)[2]
print(f"over delay - gap: {first:.2f} and {second:.2f} (book: 1.80 and 1.52)")
