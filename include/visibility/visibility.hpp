#pragma once

/// All of the library. Floors from the bottom: kernel, predicates, geometry, scene, evidence, methods.

