"""The Constructivist Learning Architecture (Chaput 2004) in Python.

* :class:`Agent`: one learner for any robot with binary items and discrete actions.
* :class:`SOM`: self-organizing maps with the interface of MiniSom.
* ``gymnasium.make("cla/Pioneer-v0")`` and its neighbours: the worlds of the project, see :mod:`cla.envs`.

The same seed lives the same life as in Rust, to the bit.
"""

from cla import envs
from cla._native import profiles as _profiles
from cla.agent import Agent, Choice, Life
from cla.som import SOM

__all__ = ["Agent", "Choice", "Life", "SOM", "envs", "PROFILES"]
__version__ = "0.2.0"

#: The profiles of :class:`Agent`, each with what it is for.
PROFILES = dict(_profiles())

envs.register()
