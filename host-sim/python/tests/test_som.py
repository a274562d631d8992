"""Maps, beside MiniSom where it is installed."""

import importlib.metadata
import pickle
import re
import unittest
import warnings
from pathlib import Path

import numpy as np
import pytest

import cla

#: Tests of MiniSom's own class that cla.SOM does not pass, and why.
LISTED = {
    "test_distance_map": (
        "on a hexagonal map with an even number of columns MiniSom's distance map takes other nodes for "
        "neighbours than those that lie at distance 1 by its own coordinates; ours takes those"
    ),
}


CONSTRAINTS = Path(__file__).parents[1] / "constraints.txt"


def uniform(samples=300, features=3, seed=0):
    return np.random.default_rng(seed).random((samples, features))


def sparse(samples=300, features=40, on=5, seed=0):
    rng = np.random.default_rng(seed)
    data = np.zeros((samples, features))
    for row in data:
        row[rng.choice(features, on, replace=False)] = 1
    return data


def test_the_tests_of_minisom_pass_but_for_those_listed(monkeypatch, tmp_path):
    minisom = pytest.importorskip("minisom")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(minisom, "MiniSom", cla.SOM)
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(minisom.TestMinisom)
    result = unittest.TestResult()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        suite.run(result)
    failed = {test._testMethodName: text for test, text in result.failures + result.errors}
    assert set(failed) == set(LISTED), "\n".join(failed.values())
    installed = importlib.metadata.version("minisom")
    pinned = re.search(r"^minisom==(.+)$", CONSTRAINTS.read_text(encoding="utf-8"), re.MULTILINE)
    assert installed == pinned[1] == "2.3.6", "another MiniSom has other tests: count them and what is listed"
    assert (result.testsRun, result.testsRun - len(failed)) == (44, 43)


@pytest.mark.parametrize("topology", ["rectangular", "hexagonal"])
@pytest.mark.parametrize("shape", ["gaussian", "mexican_hat", "bubble", "triangle"])
def test_a_training_is_that_of_minisom_up_to_rounding(topology, shape):
    minisom = pytest.importorskip("minisom")
    data = uniform()
    arguments = {
        "sigma": 2, "learning_rate": 0.2, "neighborhood_function": shape, "topology": topology, "random_seed": 3,
    }
    both = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for kind in (minisom.MiniSom, cla.SOM):
            som = kind(7, 5, 3, **arguments)
            som.train(data, 500, random_order=True)
            both.append(som)
    theirs, ours = both
    if shape == "mexican_hat":
        # It diverges in both.
        assert np.isfinite(ours.get_weights()).all() or not np.isfinite(theirs.get_weights()).all()
        return
    assert ours.get_weights() == pytest.approx(theirs.get_weights(), abs=2e-5)
    assert ours.quantization_error(data) == pytest.approx(theirs.quantization_error(data), abs=1e-5)
    assert ours.topographic_error(data) == pytest.approx(theirs.topographic_error(data), abs=1e-12)
    assert (ours.activation_response(data) == theirs.activation_response(data)).all()
    assert ours.neighborhood((2, 3), 1.5) == pytest.approx(theirs.neighborhood((2, 3), 1.5))
    # MiniSom's neighbours are those of its coordinates where the number of columns is odd.
    assert ours.distance_map() == pytest.approx(theirs.distance_map(), abs=1e-4)
    assert ours.distance_map("mean") == pytest.approx(theirs.distance_map("mean"), abs=1e-4)
    assert ours.distortion_measure(data) == pytest.approx(theirs.distortion_measure(data), rel=1e-4)
    assert [*map(tuple, ours.win_map(data))] == [*map(tuple, theirs.win_map(data))]


@pytest.mark.parametrize("distance", ["cosine", "manhattan"])
def test_other_distances_are_those_of_minisom(distance):
    minisom = pytest.importorskip("minisom")
    data = uniform()
    soms = [kind(6, 6, 3, activation_distance=distance, random_seed=2) for kind in (minisom.MiniSom, cla.SOM)]
    for som in soms:
        som.train(data, 200)
    assert soms[1].get_weights() == pytest.approx(soms[0].get_weights(), abs=2e-5)


def test_hexagonal_neighbours_are_the_nodes_at_distance_one():
    for y in (4, 5):
        som = cla.SOM(5, y, 1, topology="hexagonal")
        xx, yy = som.get_euclidean_coordinates()
        for i in range(5):
            for j in range(y):
                apart = np.hypot(xx - xx[i, j], yy - yy[i, j])
                near = {tuple(it) for it in np.argwhere(np.isclose(apart, 1))}
                assert near == set(som._neighbours(i, j))


def test_what_is_unknown_is_left_out():
    data = uniform(600, 4)
    holes = data.copy()
    holes[np.random.default_rng(1).random(data.shape) < 0.2] = np.nan
    holes[np.isnan(holes).all(axis=1), 0] = 0.5
    som = cla.SOM(8, 8, 4, sigma=2, random_seed=1)
    untrained = som.quantization_error(data)
    som.train(holes, 4000, random_order=True)
    assert np.isfinite(som.get_weights()).all()
    assert som.quantization_error(data) < 0.6 * untrained
    sample = [0.2, np.nan, 0.7, np.nan]
    apart = np.hypot(som.get_weights()[..., 0] - 0.2, som.get_weights()[..., 2] - 0.7)
    assert som.activate(sample) == pytest.approx(apart, abs=1e-6)
    assert som.winner(sample) == np.unravel_index(apart.argmin(), apart.shape)


@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize("pieces", [[600], [1, 599], [100] * 6, [17, 300, 283]])
def test_a_training_in_pieces_is_the_whole_training(binary, pieces):
    data = sparse(600)
    whole = cla.SOM(6, 5, 40, sigma=2, random_seed=1, binary=binary)
    whole.train(data, 600)
    som = cla.SOM(6, 5, 40, sigma=2, random_seed=1, binary=binary)
    begin = 0
    for piece in pieces:
        som.partial_fit(data[begin : begin + piece], total=600)
        begin += piece
        som = pickle.loads(pickle.dumps(som))
    assert som.steps == 600
    assert (som.get_weights() == whole.get_weights()).all()


def test_a_schedule_that_is_over_stays_at_its_end():
    som = cla.SOM(3, 3, 3, random_seed=1, decay_function="linear_decay_to_zero")
    som.partial_fit(uniform(50), total=50)
    rate = som._rates(np.array([49]), 50)[0][0]
    before = np.array(som.get_weights())
    sample = uniform(1, seed=9)
    winner = som.winner(sample[0])
    som.partial_fit(sample)
    moved = before[winner] + rate * (sample[0] - before[winner])
    assert som.get_weights()[winner] == pytest.approx(moved, abs=1e-6)
    with pytest.raises(ValueError, match="total"):
        cla.SOM(3, 3, 3).partial_fit(sample)


def test_the_binary_map_is_the_dense_one_up_to_rounding():
    data = sparse(400)
    data[np.random.default_rng(2).random(data.shape) < 0.02] = np.nan
    maps = [cla.SOM(8, 7, 40, sigma=2, random_seed=5, binary=binary) for binary in (False, True)]
    for som in maps:
        som.train(data, 3000, random_order=True)
    dense, binary = maps
    errors = [som.quantization_error(data) for som in maps]
    assert errors[1] == pytest.approx(errors[0], rel=1e-2)
    assert binary.activate(data[0]).shape == (8, 7)
    same = np.mean([dense.winner(it) == binary.winner(it) for it in data])
    assert same > 0.95
    assert not binary.get_weights().flags.writeable
    kept = pickle.loads(pickle.dumps(binary))
    assert (kept.get_weights() == binary.get_weights()).all()


def test_a_pickled_map_goes_on_as_if_nothing_had_been():
    data = uniform()
    one = cla.SOM(6, 6, 3, random_seed=4)
    one.train_random(data, 100)
    other = pickle.loads(pickle.dumps(one))
    for som in (one, other):
        som.train_random(data, 100)
    assert (one.get_weights() == other.get_weights()).all()


def test_weights_are_a_view_that_may_be_written():
    som = cla.SOM(4, 3, 2)
    som.get_weights()[1, 2] = [5.0, 6.0]
    assert som.winner([5, 6]) == (1, 2)
    som._weights = np.zeros((4, 3, 2))
    assert som.quantization_error([[3.0, 4.0]]) == 5.0
    assert som.winner([1, 1]) == (0, 0)


@pytest.mark.parametrize("kind", [np.int8, np.uint8, bool, np.int64, np.float16, np.float64, list])
def test_numbers_of_any_type_are_the_same_numbers(kind):
    data = sparse(20, 6, 2)
    som = cla.SOM(3, 3, 6, random_seed=1)
    som.train(data.tolist() if kind is list else data.astype(kind), 20)
    same = cla.SOM(3, 3, 6, random_seed=1)
    same.train(data, 20)
    assert (som.get_weights() == same.get_weights()).all()


def test_arrays_in_any_order_of_memory_are_the_same():
    data = uniform(40, 6)
    maps = []
    for form in (data, np.asfortranarray(data), data[::-1][::-1], data.astype(">f8")):
        som = cla.SOM(3, 3, 6, random_seed=1)
        som.train(form, 40)
        maps.append(np.array(som.get_weights()))
    assert all((it == maps[0]).all() for it in maps)


@pytest.mark.parametrize(
    ("data", "words"),
    [
        ([[1.0, 2.0]], "shape"),
        ([1.0, 2.0, 3.0], "shape"),
        ([], "shape"),
        (np.zeros((0, 3)), "no sample"),
        ([["a", "b", "c"]], "numbers"),
        ([[1.0, float("inf"), 0.0]], "feature 1 of sample 0"),
        ([[0.0, 0.0, 0.0], [1e30, 0.0, 0.0]], "feature 0 of sample 1"),
        ([[float("nan")] * 3], "no known feature"),
        ([[1j, 0, 0]], "numbers"),
    ],
)
def test_samples_that_are_none_are_refused_and_change_nothing(data, words):
    som = cla.SOM(3, 3, 3, random_seed=1)
    before = np.array(som.get_weights())
    for use in (lambda: som.train(data, 5), lambda: som.quantization_error(data), lambda: som.partial_fit(data, 5)):
        with pytest.raises(ValueError, match=words) as refused:
            use()
        assert "\n" not in str(refused.value)
    assert (som.get_weights() == before).all()


def test_a_binary_map_takes_zeros_and_ones_alone():
    som = cla.SOM(3, 3, 3, binary=True)
    with pytest.raises(ValueError, match="feature 1 is 0, 1 or NaN"):
        som.train([[0, 0.5, 1]], 1)
    for arguments in ({"learning_rate": 2}, {"neighborhood_function": "triangle"}, {"activation_distance": "cosine"}):
        with pytest.raises(ValueError, match="binary"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            cla.SOM(3, 3, 3, binary=True, **arguments)


@pytest.mark.parametrize(
    "arguments",
    [
        {"x": 0}, {"y": -1}, {"input_len": 0}, {"x": 2.5}, {"sigma": -1}, {"sigma": float("nan")},
        {"learning_rate": float("inf")}, {"topology": "round"}, {"neighborhood_function": "square"},
        {"decay_function": "strawberry"}, {"decay_function": 3}, {"sigma_decay_function": "no"},
        {"activation_distance": "far"}, {"activation_distance": 3},
    ],
)  # fmt: skip
def test_an_impossible_map_is_refused(arguments):
    with pytest.raises(ValueError):
        cla.SOM(**{"x": 3, "y": 3, "input_len": 2, **arguments})


def test_a_decay_that_leads_nowhere_is_refused():
    som = cla.SOM(3, 3, 2, decay_function=lambda rate, t, steps: float("nan"))
    with pytest.raises(ValueError, match="decay"):
        som.train(uniform(5, 2), 5)
