// Presets: one name for the tangent rule and the end rule of a product.
#pragma once

#include <array>
#include <string_view>

namespace tcb::spline {

struct Preset {
  std::string_view name;
  std::string_view tangents;  ///< a name of tangent_rules
  std::string_view ends;      ///< a name of end_rules
  std::string_view product;
};

/// Every preset by name; the first is the default.
inline constexpr std::array presets{
    Preset{"gte", "velocity", "half", "Geometric Tools Engine since 2022-08"},
    Preset{"fbx", "velocity", "one-sided", "FBX, MotionBuilder"},
    Preset{"gte2021", "interval", "one-sided", "Geometric Tools Engine until 2022-01"},
    Preset{"wildmagic", "interval", "one-sided", "Wild Magic"},
    Preset{"lightwave", "interval", "lightwave", "LightWave 3D; times in seconds"},
    Preset{"vtk", "interval", "zero", "VTK with its default ends"},
    Preset{"gamebryo", "interval", "mirror", "Gamebryo, NetImmerse (NIF files)"},
    Preset{"idtech4", "interval", "mirror", "id Tech 4"},
    Preset{"3dsmax", "interval-c", "natural-tension", "3ds Max; with ease columns"},
    Preset{"nel", "interval-c", "natural-tension", "NeL; with ease columns"},
    Preset{"cryengine", "interval-c", "cry", "CryEngine; with ease columns"},
    Preset{"lib3ds1", "interval-c", "chord", "lib3ds 1"},
    Preset{"lib3ds2", "interval-c", "mirror", "lib3ds 2"},
    Preset{"splines", "finite-difference", "natural", "the Python package splines"},
    Preset{"synfig", "synfig", "chord", "Synfig"},
    Preset{"kb1984", "kb1984", "half", "the paper of 1984 as printed"},
    Preset{"wikipedia", "uniform", "half", "the encyclopaedia article"},
    Preset{"ogre", "uniform", "half", "OGRE Procedural"},
};

}  // namespace tcb::spline
