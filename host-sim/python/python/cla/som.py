"""Self-organizing maps with the interface of MiniSom, computed in Rust in single precision."""

from __future__ import annotations

from collections import Counter, defaultdict
from typing import Any, Callable, Mapping
from warnings import warn

import numpy as np
from numpy.typing import ArrayLike, NDArray

from cla import _checked
from cla import _native

__all__ = ["SOM"]

Floats = NDArray[np.float64]
Node = tuple[int, int]
#: Of a decay: the number at the beginning, the step, the steps in all.
Decay = Callable[..., Any]

_SHAPES = ("gaussian", "mexican_hat", "bubble", "triangle")
_TOPOLOGIES = ("rectangular", "hexagonal")
_FARTHEST = 1e15


def _known(kind: str, name: Any, known: Any) -> None:
    if name not in known:
        raise ValueError(f"{name!r} is no {kind}: there are {', '.join(known)}")


class SOM:
    """A self-organizing map.

    Parameters
    ----------
    x, y : int
        Nodes along the two sides.
    input_len : int
        Features of a sample.
    sigma : float
        Width of the neighbourhood at the beginning, in nodes.
    learning_rate : float
        Share of the way that the winner goes at the beginning.
    decay_function : str or callable
        How the learning rate falls: ``"asymptotic_decay"``, ``"inverse_decay_to_zero"``,
        ``"linear_decay_to_zero"``, or a function of rate, step and steps.
    neighborhood_function : str
        ``"gaussian"``, ``"mexican_hat"``, ``"bubble"`` or ``"triangle"``.
    topology : str
        ``"rectangular"`` or ``"hexagonal"``.
    activation_distance : str or callable
        ``"euclidean"``, ``"cosine"``, ``"manhattan"``, ``"chebyshev"``, or a function of a sample and
        the weights.  Only the first is computed in Rust.
    random_seed : int, optional
        Decides the first weights and every order; the first weights are those of MiniSom.
    sigma_decay_function : str
        ``"asymptotic_decay"``, ``"inverse_decay_to_one"`` or ``"linear_decay_to_one"``.
    binary : bool
        For samples of 0 and 1 of which few are on: the work grows with those that are on.

    A feature that is NaN is unknown: it counts neither in the search nor in the update.
    Weights are ``float32``; with the same seed a training is that of MiniSom up to rounding.

    Examples
    --------
    >>> import numpy as np
    >>> import cla
    >>> data = np.random.default_rng(0).random((200, 3))
    >>> som = cla.SOM(6, 6, 3, sigma=1.5, random_seed=1)
    >>> som.train(data, 2000)
    >>> som.quantization_error(data) < 0.2
    True
    """

    def __init__(
        self,
        x: int,
        y: int,
        input_len: int,
        sigma: float = 1,
        learning_rate: float = 0.5,
        decay_function: str | Decay = "asymptotic_decay",
        neighborhood_function: str = "gaussian",
        topology: str = "rectangular",
        activation_distance: str | Callable[[Any, Any], Any] = "euclidean",
        random_seed: int | None = None,
        sigma_decay_function: str = "asymptotic_decay",
        *,
        binary: bool = False,
    ) -> None:
        x = _checked.whole("x", x, 1, 4096)
        y = _checked.whole("y", y, 1, 4096)
        self._input_len = _checked.whole("input_len", input_len, 1, 65_535)
        self._sigma = _checked.finite("sigma", sigma)
        self._learning_rate = _checked.finite("learning_rate", learning_rate)
        if self._sigma < 0 or self._learning_rate < 0:
            raise ValueError("sigma and learning_rate are not negative")
        _known("topology", topology, _TOPOLOGIES)
        _known("neighborhood_function", neighborhood_function, _SHAPES)
        _known("sigma_decay_function", sigma_decay_function, self._sigma_decays())
        if isinstance(decay_function, str):
            _known("decay_function", decay_function, self._rate_decays())
        elif not callable(decay_function):
            raise ValueError("decay_function is a name or can be called")
        if isinstance(activation_distance, str):
            _known("activation_distance", activation_distance, self._distances())
        elif not callable(activation_distance):
            raise ValueError("activation_distance is a name or can be called")
        self.topology = topology
        self.binary = bool(binary)
        self._shape = neighborhood_function
        self._decay = decay_function
        self._sigma_decay = sigma_decay_function
        self._distance = activation_distance
        self._warn(x, y)
        if self.binary and (
            activation_distance != "euclidean"
            or neighborhood_function not in ("gaussian", "bubble")
            or self._learning_rate > 1
        ):
            raise ValueError(
                "a binary map has euclidean distances, a gaussian or bubble neighbourhood, "
                "and a learning rate up to 1"
            )
        self._neigx, self._neigy = np.arange(x), np.arange(y)
        rows, columns = np.meshgrid(self._neigx.astype(float), self._neigy.astype(float))
        if topology == "hexagonal":
            rows[::-2] -= 0.5
            columns *= np.sqrt(3) / 2
        self._xx, self._yy = rows, columns
        self._random_generator = np.random.RandomState(random_seed)
        first = self._random_generator.rand(x, y, self._input_len) * 2 - 1
        first /= np.linalg.norm(first, axis=-1, keepdims=True)
        self._activation_map = np.zeros((x, y))
        # Feature by feature: what Rust works on, in place.
        self._store = np.zeros((self._input_len, x * y), dtype=np.float32)
        self._scale = np.ones(x * y, dtype=np.float32)
        self._norm = np.zeros(x * y, dtype=np.float32)
        self._weights = first
        #: Steps of :meth:`partial_fit` so far.
        self.steps = 0

    def _warn(self, x: int, y: int) -> None:
        if self._sigma > np.sqrt(x * x + y * y):
            warn("sigma is larger than the map", stacklevel=3)
        if self._shape in ("bubble", "triangle") and (self._sigma < 1 or self._sigma % 1):
            warn(f"a {self._shape} neighbourhood has a whole sigma of at least 1", stacklevel=3)
        if self._shape == "triangle" and self.topology == "hexagonal":
            warn("a triangle neighbourhood knows nothing of a hexagonal topology", stacklevel=3)

    # --- weights and places ---------------------------------------------------------------------

    @property
    def shape(self) -> tuple[int, int, int]:
        """Nodes along x and y, and features."""
        return len(self._neigx), len(self._neigy), self._input_len

    @property
    def _weights(self) -> NDArray[np.float32]:
        if self.binary:
            _native.som_binary_fold((self._store, self._scale, self._norm))
        x, y, features = self.shape
        view = self._store.reshape(features, x, y).transpose(1, 2, 0)
        # The |m|² of a binary map would not follow what is written into its weights.
        view.flags.writeable = not self.binary
        return view

    @_weights.setter
    def _weights(self, weights: ArrayLike) -> None:
        x, y, features = self.shape
        array = np.asarray(weights, dtype=np.float32)
        if array.size != x * y * features:
            raise ValueError(f"the weights of this map have shape {self.shape}, not {array.shape}")
        if not np.isfinite(array).all():
            raise ValueError("weights are finite")
        self._store[:] = array.reshape(x, y, features).transpose(2, 0, 1).reshape(features, x * y)
        self._scale[:] = 1
        if self.binary:
            _native.som_binary_fold((self._store, self._scale, self._norm))

    def get_weights(self) -> NDArray[np.float32]:
        """The weights, shape (x, y, input_len): a view of the map itself; read-only on a binary map."""
        return self._weights

    def get_euclidean_coordinates(self) -> tuple[Floats, Floats]:
        """Where each node lies in the plane: two arrays of shape (x, y)."""
        return self._xx.T, self._yy.T

    def convert_map_to_euclidean(self, xy: Node) -> Node:
        """Where a node lies in the plane."""
        return self._xx.T[xy], self._yy.T[xy]

    # --- decays, neighbourhoods, distances ------------------------------------------------------

    def _rate_decays(self) -> Mapping[str, Decay]:
        return {
            "asymptotic_decay": self._asymptotic_decay,
            "inverse_decay_to_zero": self._inverse_decay_to_zero,
            "linear_decay_to_zero": self._linear_decay_to_zero,
        }

    def _sigma_decays(self) -> Mapping[str, Decay]:
        return {
            "asymptotic_decay": self._asymptotic_decay,
            "inverse_decay_to_one": self._inverse_decay_to_one,
            "linear_decay_to_one": self._linear_decay_to_one,
        }

    def _distances(self) -> Mapping[str, Callable[[Any, Any], Any]]:
        return {
            "euclidean": self._euclidean_distance,
            "cosine": self._cosine_distance,
            "manhattan": self._manhattan_distance,
            "chebyshev": self._chebyshev_distance,
        }

    @staticmethod
    def _asymptotic_decay(start: Any, t: Any, steps: Any) -> Any:
        return start / (1 + t / (steps / 2))

    @staticmethod
    def _inverse_decay_to_zero(start: Any, t: Any, steps: Any) -> Any:
        hundredth = steps / 100
        return start * hundredth / (hundredth + t)

    @staticmethod
    def _linear_decay_to_zero(start: Any, t: Any, steps: Any) -> Any:
        return start * (1 - t / steps)

    @staticmethod
    def _inverse_decay_to_one(start: Any, t: Any, steps: Any) -> Any:
        return start / (1 + t * ((start - 1) / steps))

    @staticmethod
    def _linear_decay_to_one(start: Any, t: Any, steps: Any) -> Any:
        return start + t * (1 - start) / steps

    def _rates(self, times: NDArray[np.int64], steps: int) -> tuple[Any, Any]:
        """Learning rates and widths at some steps, as ``float32``."""
        if callable(self._decay):
            alphas = np.array([self._decay(self._learning_rate, int(t), steps) for t in times])
        else:
            decay = self._rate_decays()[self._decay]
            alphas = np.asarray(decay(self._learning_rate, times, steps)) + np.zeros(len(times))
        falling = self._sigma_decays()[self._sigma_decay](self._sigma, times, steps)
        widths = np.asarray(falling) + np.zeros(len(times))
        if not (np.isfinite(alphas).all() and np.isfinite(widths).all()):
            raise ValueError("a decay function led to a number that is not finite")
        if self.binary and ((alphas < 0) | (alphas > 1)).any():
            raise ValueError("learning rates of a binary map are from 0 to 1")
        return alphas.astype(np.float32), widths.astype(np.float32)

    def neighborhood(self, winner: Node, sigma: float) -> Floats:
        """How near each node is to a winner, shape (x, y); 1 at the winner but for ``"triangle"``."""
        near: Floats = getattr(self, f"_{self._shape}")(winner, sigma)
        return near

    def _gaussian(self, winner: Node, sigma: float) -> Floats:
        dx, dy = self._apart(winner)
        width = 2 * sigma * sigma
        return np.exp(-(dx**2) / width) * np.exp(-(dy**2) / width)

    def _mexican_hat(self, winner: Node, sigma: float) -> Floats:
        dx, dy = self._apart(winner)
        squared, width = dx**2 + dy**2, 2 * sigma * sigma
        return np.exp(-squared / width) * (1 - 2 / width * squared)

    def _bubble(self, winner: Node, sigma: float) -> Floats:
        near_x, near_y = (np.abs(it) < sigma for it in self._steps_apart(winner))
        return np.outer(near_x, near_y).astype(float)

    def _triangle(self, winner: Node, sigma: float) -> Floats:
        x, y = (np.maximum(sigma - np.abs(it), 0) for it in self._steps_apart(winner))
        return np.outer(x, y).astype(float)

    def _apart(self, winner: Node) -> tuple[Floats, Floats]:
        at = tuple(winner)
        return self._xx.T - self._xx.T[at], self._yy.T - self._yy.T[at]

    def _steps_apart(self, winner: Node) -> tuple[Any, Any]:
        return self._neigx - winner[0], self._neigy - winner[1]

    @staticmethod
    def _euclidean_distance(sample: Any, weights: Any) -> Any:
        return np.sqrt(np.nansum((np.asarray(sample) - weights) ** 2, axis=-1))

    @staticmethod
    def _cosine_distance(sample: Any, weights: Any) -> Any:
        sample = np.asarray(sample)
        kept = np.where(np.isnan(sample), 0, weights)
        product = np.nansum(weights * sample, axis=-1)
        norms = np.linalg.norm(kept, axis=-1) * np.sqrt(np.nansum(sample**2))
        return 1 - product / (norms + 1e-8)

    @staticmethod
    def _manhattan_distance(sample: Any, weights: Any) -> Any:
        return np.nansum(np.abs(np.asarray(sample) - weights), axis=-1)

    @staticmethod
    def _chebyshev_distance(sample: Any, weights: Any) -> Any:
        return np.nanmax(np.abs(np.asarray(sample) - weights), axis=-1)

    # --- one sample -----------------------------------------------------------------------------

    def _sample(self, sample: ArrayLike) -> NDArray[np.float32]:
        """One sample, checked."""
        array = np.asarray(sample)
        if array.ndim == 0:
            array = array.reshape(1)
        checked: NDArray[np.float32] = self._data(array.reshape(1, -1))[0]
        return checked

    def activate(self, x: ArrayLike) -> Floats:
        """The distance of a sample from every node, shape (x, y)."""
        sample = self._sample(x)
        if self._distance == "euclidean":
            distances = np.sqrt(self._squared(sample))
        elif callable(self._distance):
            distances = np.asarray(self._distance(sample, self._weights))
        else:
            distances = self._distances()[self._distance](sample, self._weights)
        self._activation_map = np.asarray(distances).reshape(self.shape[:2])
        return self._activation_map

    def _activate(self, x: ArrayLike) -> None:
        self.activate(x)

    def _squared(self, sample: NDArray[np.float32]) -> NDArray[np.float32]:
        if self.binary:
            return _native.som_binary_distances((self._store, self._scale, self._norm), sample)
        return _native.som_distances(self._store, sample)

    def _winning(self, sample: NDArray[np.float32]) -> int:
        """The number of the winner of a sample that was checked; ties go to the lowest."""
        if self._distance == "euclidean":
            return int(self._squared(sample).argmin())
        return int(self.activate(sample).argmin())

    def _place(self, number: int) -> Node:
        return divmod(number, len(self._neigy))

    def winner(self, x: ArrayLike) -> Node:
        """The best matching unit of a sample; of equally near ones the lowest."""
        return self._place(self._winning(self._sample(x)))

    def update(self, x: ArrayLike, win: Node, t: int, max_iteration: int) -> None:
        """Moves the nodes around ``win`` towards a sample, as at step ``t`` of ``max_iteration``."""
        number = self._number(win)
        self._run(self._sample(x)[None], [0], np.array([t]), max_iteration, {0: number})

    def _number(self, node: Node) -> int:
        i = _checked.whole("a node's place along x", node[0], 0, len(self._neigx) - 1)
        j = _checked.whole("a node's place along y", node[1], 0, len(self._neigy) - 1)
        return i * len(self._neigy) + j

    # --- training -------------------------------------------------------------------------------

    def _check_iteration_number(self, num_iteration: int) -> int:
        return _checked.whole("num_iteration", num_iteration, 1, 2**40)

    def _check_input_len(self, data: Any) -> None:
        width = len(data[0]) if len(data) and np.ndim(data[0]) else None
        if width != self._input_len:
            raise ValueError(f"a sample of this map has {self._input_len} features, not {width}")

    def _data(self, data: ArrayLike) -> NDArray[np.float32]:
        """Samples, shape (samples, input_len), checked: finite, or NaN for unknown."""
        array = np.asarray(data)
        if array.dtype.kind not in "biuf":
            raise ValueError(f"data are numbers, not {array.dtype}")
        if array.ndim != 2 or array.shape[1] != self._input_len:
            raise ValueError(
                f"data have shape (samples, {self._input_len}), not {tuple(array.shape)}"
            )
        if not len(array):
            raise ValueError("there is no sample")
        if array.dtype.kind == "f":
            unknown = np.isnan(array)
            far = np.abs(array.astype(np.float64)) > _FARTHEST
            if far.any():
                at, feature = np.argwhere(far)[0]
                raise ValueError(
                    f"feature {feature} of sample {at} is infinite or farther from 0 than 1e15"
                )
            if unknown.any() and unknown.all(axis=1).any():
                at = int(np.argmax(unknown.all(axis=1)))
                raise ValueError(f"sample {at} has no known feature")
        return np.ascontiguousarray(array, dtype=np.float32)

    def _run(
        self,
        data: NDArray[np.float32],
        order: Any,
        times: NDArray[np.int64],
        steps: int,
        fixed: Mapping[int, int] | None = None,
    ) -> None:
        """Trains on checked samples in an order; ``fixed`` has winners by sample."""
        alphas, widths = self._rates(times, steps)
        order = np.ascontiguousarray(order, dtype=np.int64)
        winners = np.full(len(order), -1, dtype=np.int64)
        for sample, number in (fixed or {}).items():
            winners[order == sample] = number
        if self._distance != "euclidean":
            self._run_slowly(data, order, (alphas, widths), winners)
            return
        x, y, _ = self.shape
        lattice = (x, y, self.topology == "hexagonal", self._shape)
        plan = (order, alphas, widths, winners)
        if self.binary:
            arrays = (self._store, self._scale, self._norm)
            _native.som_binary_train(arrays, lattice, data, plan)
        else:
            _native.som_train(self._store, lattice, data, plan)

    def _run_slowly(self, data: Any, order: Any, rates: Any, winners: Any) -> None:
        """The same where only Python knows the distance."""
        for sample, alpha, width, winner in zip(data[order], *rates, winners):
            number = self._winning(sample) if winner < 0 else int(winner)
            near = alpha * self.neighborhood(self._place(number), float(width))
            known = ~np.isnan(sample)
            store = self._store[known]
            store += near.reshape(-1).astype(np.float32) * (sample[known, None] - store)
            self._store[known] = store

    def train(
        self,
        data: ArrayLike,
        num_iteration: int,
        random_order: bool = False,
        verbose: bool = False,
        use_epochs: bool = False,
        fixed_points: Mapping[int, Node] | None = None,
    ) -> None:
        """Trains for so many steps, or epochs, whose rates fall from the beginning to the end.

        Parameters
        ----------
        data : array of shape (samples, input_len)
            NaN where a feature is unknown.
        num_iteration : int
            Steps; with ``use_epochs`` times through all samples, in which the rates stay.
        random_order : bool
            Whether the samples come in an order by chance.
        verbose : bool
            Whether the quantization error is printed at the end.
        fixed_points : dict, optional
            Winners of some samples, by their index.
        """
        num_iteration = self._check_iteration_number(num_iteration)
        samples = self._data(data)
        fixed = self._check_fixed_points(fixed_points or {}, samples)
        if use_epochs:
            one = np.arange(len(samples))
            if random_order:
                self._random_generator.shuffle(one)
            order = np.tile(one, num_iteration)
            times = np.repeat(np.arange(num_iteration), len(samples))
        else:
            order = np.arange(num_iteration) % len(samples)
            if random_order:
                self._random_generator.shuffle(order)
            times = np.arange(num_iteration)
        self._run(samples, order, times, num_iteration, fixed)
        if verbose:
            print("quantization error:", self.quantization_error(data))

    def _check_fixed_points(self, fixed_points: Mapping[int, Node], data: Any) -> dict[int, int]:
        fixed = {}
        for sample, node in fixed_points.items():
            if not isinstance(sample, (int, np.integer)):
                raise TypeError(f"a fixed point has the index of a sample, not {sample!r}")
            at = _checked.whole("the sample of a fixed point", sample, 0, len(data) - 1)
            fixed[at] = self._number(node)
        return fixed

    def train_random(self, data: ArrayLike, num_iteration: int, verbose: bool = False) -> None:
        """:meth:`train` in an order by chance."""
        self.train(data, num_iteration, random_order=True, verbose=verbose)

    def train_batch(self, data: ArrayLike, num_iteration: int, verbose: bool = False) -> None:
        """:meth:`train` in the order of the samples."""
        self.train(data, num_iteration, verbose=verbose)

    def partial_fit(self, data: ArrayLike, total: int | None = None) -> "SOM":
        """Goes on with a training of ``total`` steps, one for each sample, from where it stands.

        The rates are those of :meth:`train` with ``total`` steps: however the samples are cut into
        pieces, and though the map was pickled in between, the weights are the same to the bit.  After
        ``total`` steps they stay as at its end.  :attr:`steps` is where it stands; set it to 0 to begin
        anew.  ``total`` may be left out after the first call.
        """
        if total is not None:
            self._total = self._check_iteration_number(total)
        elif not hasattr(self, "_total"):
            raise ValueError("the first partial_fit needs the number of steps in total")
        samples = self._data(data)
        times = np.minimum(self.steps + np.arange(len(samples)), self._total - 1)
        self._run(samples, np.arange(len(samples)), times, self._total)
        self.steps += len(samples)
        return self

    def train_batch_offline(
        self, data: ArrayLike, num_iteration: int, verbose: bool = False
    ) -> None:
        """The batch map (Kohonen 2013): weights change once in an iteration, after all samples."""
        num_iteration = self._check_iteration_number(num_iteration)
        samples = self._data(data)
        alphas, widths = self._rates(np.arange(num_iteration), num_iteration)
        known = ~np.isnan(samples)
        filled = np.where(known, samples, 0).astype(float)
        nodes = len(self._scale)
        for alpha, width in zip(alphas.astype(float), widths.astype(float)):
            near = np.zeros((len(samples), nodes))
            for at, sample in enumerate(samples):
                near[at] = self.neighborhood(self._place(self._winning(sample)), width).reshape(-1)
            shares = near.T @ known
            means = np.divide(near.T @ filled, shares, out=np.zeros_like(shares), where=shares > 0)
            weights = np.asarray(self._weights, dtype=float).reshape(nodes, -1)
            moved = np.where(shares > 0, (1 - alpha) * weights + alpha * means, weights)
            self._weights = moved.reshape(self.shape)
        if verbose:
            print("quantization error:", self.quantization_error(data))

    def random_weights_init(self, data: ArrayLike) -> None:
        """Makes each node one of the samples, by chance."""
        samples = self._data(data)
        weights = np.array(self._weights)
        for i in self._neigx:
            for j in self._neigy:
                sample = samples[self._random_generator.randint(len(samples))]
                weights[i, j] = np.where(np.isnan(sample), weights[i, j], sample)
        self._weights = weights

    def pca_weights_init(self, data: ArrayLike) -> None:
        """Lays the map into the plane of the first two principal components, without chance."""
        if self._input_len == 1:
            raise ValueError("principal components need at least 2 features")
        if 1 in self.shape[:2]:
            warn("a map with one row has no plane for two principal components", stacklevel=2)
        samples = self._data(data).astype(float)
        if np.isnan(samples).any():
            raise ValueError("principal components need all features of every sample")
        values, vectors = np.linalg.eigh(np.cov(samples, rowvar=False))
        first, second = (vectors[:, at] for at in np.argsort(values)[::-1][:2])
        along = np.linspace(-1, 1, len(self._neigx))[:, None, None] * first
        across = np.linspace(-1, 1, len(self._neigy))[None, :, None] * second
        self._weights = samples.mean(axis=0) + along + across

    # --- what it represents ---------------------------------------------------------------------

    def _winners(self, data: ArrayLike) -> tuple[NDArray[np.float32], list[int]]:
        samples = self._data(data)
        return samples, [self._winning(sample) for sample in samples]

    def quantization(self, data: ArrayLike) -> NDArray[np.float32]:
        """The prototype of each sample's nearest node, shape (samples, input_len)."""
        _, squared = self._all_squared(data)
        weights: NDArray[np.float32] = np.asarray(self._weights).reshape(-1, self._input_len)
        nearest: NDArray[np.float32] = weights[squared.argmin(axis=1)]
        return nearest

    def _all_squared(self, data: ArrayLike) -> tuple[Any, Any]:
        samples = self._data(data)
        return samples, np.stack([self._squared(sample) for sample in samples])

    def _distance_from_weights(self, data: ArrayLike) -> Any:
        return np.sqrt(self._all_squared(data)[1])

    def quantization_error(self, data: ArrayLike) -> float:
        """The mean distance, over the known features, of a sample from its nearest node."""
        samples, squared = self._all_squared(data)
        nearest = np.asarray(self._weights).reshape(-1, self._input_len)[squared.argmin(axis=1)]
        apart = samples.astype(float) - nearest
        return float(np.sqrt(np.nansum(apart**2, axis=1)).mean())

    def distortion_measure(self, data: ArrayLike) -> float:
        """The sum over samples and nodes of neighbourhood times distance."""
        total = 0.0
        for sample in self._data(data):
            near = self.neighborhood(self._place(self._winning(sample)), self._sigma)
            total += float((near * self._euclidean_distance(sample, self._weights)).sum())
        return total

    def topographic_error(self, data: ArrayLike) -> float:
        """The share of samples whose two nearest nodes are no neighbours; NaN on a map of one node.

        On a rectangular map a node has eight neighbours, on a hexagonal one six.
        """
        if len(self._scale) == 1:
            warn("a map of one node has no topographic error", stacklevel=2)
            return float("nan")
        _, squared = self._all_squared(data)
        best = np.argsort(squared, axis=1, kind="stable")[:, :2]
        xx, yy = (it.reshape(-1)[best] for it in (self._xx.T, self._yy.T))
        apart = np.hypot(np.diff(xx)[:, 0], np.diff(yy)[:, 0])
        limit = 1.42 if self.topology == "rectangular" else 1.01
        return float((apart > limit).mean())

    def distance_map(self, scaling: str = "sum") -> Floats:
        """How far each node is from its neighbours, over the largest of all, shape (x, y).

        ``scaling`` is ``"sum"`` or ``"mean"`` over the neighbours.
        """
        _known("scaling", scaling, ("sum", "mean"))
        x, y, _ = self.shape
        weights = np.asarray(self._weights, dtype=float)
        sums, counts = np.zeros((x, y)), np.zeros((x, y))
        for i in range(x):
            for j in range(y):
                near = [
                    float(np.linalg.norm(weights[i, j] - weights[h, k]))
                    for h, k in self._neighbours(i, j)
                ]
                sums[i, j], counts[i, j] = np.sum(near), len(near)
        if scaling == "mean":
            sums = np.divide(sums, counts, out=np.zeros_like(sums), where=counts > 0)
        largest = sums.max()
        return sums / largest if largest > 0 else sums

    def _neighbours(self, i: int, j: int) -> list[Node]:
        """The eight around a node, or the six: of every second row, counted from the last, one more to
        the left."""
        x, y, _ = self.shape
        if self.topology == "rectangular":
            around = [(h, k) for h in (-1, 0, 1) for k in (-1, 0, 1) if (h, k) != (0, 0)]
        else:
            aside = -1 if (y - 1 - j) % 2 == 0 else 1
            around = [(-1, 0), (1, 0), (0, -1), (0, 1), (aside, -1), (aside, 1)]
        places = [(i + h, j + k) for h, k in around]
        return [(h, k) for h, k in places if 0 <= h < x and 0 <= k < y]

    def activation_response(self, data: ArrayLike) -> Floats:
        """How many samples each node wins, shape (x, y)."""
        counts = np.bincount(self._winners(data)[1], minlength=len(self._scale))
        return counts.reshape(self.shape[:2]).astype(float)

    def win_map(self, data: Any, return_indices: bool = False) -> dict[Node, list[Any]]:
        """The samples that each node wins, or their indices, by the node's place."""
        _, winners = self._winners(data)
        won: dict[Node, list[Any]] = defaultdict(list)
        for at, number in enumerate(winners):
            won[self._place(number)].append(at if return_indices else data[at])
        return won

    def labels_map(self, data: ArrayLike, labels: Any) -> dict[Node, "Counter[Any]"]:
        """How many samples of each label a node wins, by the node's place."""
        if len(data) != len(labels):  # type: ignore[arg-type]
            raise ValueError("data and labels have the same length")
        _, winners = self._winners(data)
        counts: dict[Node, "Counter[Any]"] = defaultdict(Counter)
        for number, label in zip(winners, labels):
            counts[self._place(number)][label] += 1
        return counts

    def __repr__(self) -> str:
        x, y, features = self.shape
        return f"SOM({x}, {y}, {features}, {self.topology}{', binary' if self.binary else ''})"
