"""Chapter 3: maps joined into a tree, and what only the upper one can tell.

Two lower layers see a shape and a colour; the layer above reads both activations.  A pair that never
came together is nothing new for either lower layer, but it is for the upper one: overload (3.4).
"""

import numpy as np

import cla

SIGMA = 0.4  # of the activation: a = exp(-d^2 / 2 SIGMA^2)
rng = np.random.default_rng(2)
FAMILIAR = [(0, 0), (1, 1), (2, 2), (3, 3), (0, 2), (1, 3)]


def stimulus(kind):
    """Eight numbers, of which one of four pairs is high."""
    seen = rng.normal(0, 0.05, 8)
    seen[2 * kind : 2 * kind + 2] += 1
    return seen


def activation(som, seen):
    """The activation vector of a layer, which is the stimulus of the next."""
    return np.exp(-(np.asarray(som.activate(seen), dtype=float) ** 2) / (2 * SIGMA**2)).ravel()


pairs = [FAMILIAR[it] for it in rng.integers(len(FAMILIAR), size=4000)]
shapes = np.array([stimulus(shape) for shape, _ in pairs])
colours = np.array([stimulus(colour) for _, colour in pairs])

shape_layer = cla.SOM(6, 6, 8, sigma=3, random_seed=1)
colour_layer = cla.SOM(6, 6, 8, sigma=3, random_seed=2)
shape_layer.train(shapes, 4000)
colour_layer.train(colours, 4000)


def joined(shape, colour):
    return np.concatenate([activation(shape_layer, shape), activation(colour_layer, colour)])


top = cla.SOM(6, 6, 72, sigma=3, random_seed=3)
top.train(np.array([joined(*both) for both in zip(shapes, colours)]), 4000)


def distances(shape, colour):
    seen = stimulus(shape), stimulus(colour)
    layers = (shape_layer, seen[0]), (colour_layer, seen[1]), (top, joined(*seen))
    return [float(som.activate(it).min()) for som, it in layers]


new = [(a, b) for a in range(4) for b in range(4) if (a, b) not in FAMILIAR]
known = np.mean([distances(*it) for it in FAMILIAR for _ in range(50)], axis=0)
strange = np.mean([distances(*it) for it in new for _ in range(50)], axis=0)
print("distance of the best matching unit: pairs that came together, and new ones")
for name, old, other in zip(("shape", "colour", "top"), known, strange):
    print(f"  {name:7} {old:.3f}  {other:.3f}   {other / old:.1f} x")
print("fallback: the top does not know the new pairs, and the lower layers still answer")
