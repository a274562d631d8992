"""Chapter 2: a self-organizing map unfolds over its stimuli, also where some of them are unknown."""

import numpy as np

import cla

rng = np.random.default_rng(1)
angles = rng.uniform(0, 2 * np.pi, 3000)
radii = np.sqrt(rng.uniform(0.25, 1, 3000))
ring = np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])

print("a map of 12 x 12 nodes, 3000 points of a ring")
for topology in ("rectangular", "hexagonal"):
    som = cla.SOM(12, 12, 2, sigma=4, learning_rate=0.5, topology=topology, random_seed=1)
    before = som.quantization_error(ring), som.topographic_error(ring)
    som.train(ring, 20_000, random_order=True)
    after = som.quantization_error(ring), som.topographic_error(ring)
    print(f"  {topology:12} quantization {before[0]:.3f} -> {after[0]:.3f}", end="   ")
    print(f"topographic {before[1]:.3f} -> {after[1]:.3f}")
    used = (som.activation_response(ring) > 0).mean()
    print(f"  {'':12} {100 * used:.0f} % of the nodes win something")

holes = ring.copy()
holes[rng.random(3000) < 0.3, 1] = np.nan
som = cla.SOM(12, 12, 2, sigma=4, random_seed=1)
for piece in np.array_split(holes[rng.integers(3000, size=20_000)], 50):
    som.partial_fit(piece, total=20_000)
print(f"with 30 % of one coordinate unknown, in 50 pieces: {som.quantization_error(ring):.3f}")
