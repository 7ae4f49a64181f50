// The library tcb::spline: Kochanek-Bartels curves by time and by arc length. This header includes all of it.
//
// Build with -ffp-contract=off (the CMake target tcb::spline sets it), round to nearest and without -ffast-math: then
// the results have the same bits with every compiler and machine.
//
// Keys (key.hpp) and CurveRules (curve_rules.hpp) describe a curve. Curve (curve.hpp) keeps it, for any time or length
// in any order; CurveStream (curve_stream.hpp) makes its segments while keys come in, in constant memory. A complete
// program, which tests/library runs:
//
//     #include <tcb/spline/spline.hpp>
//
//     #include <array>
//     #include <cstdio>
//
//     using namespace tcb::spline;
//
//     int main() {
//       Keys<double> keys;
//       keys.channels = 2;                                       // x and y
//       keys.times = {10.0, 11.0, 13.0, 14.0};                   // increasing
//       keys.positions = {0, 0, 2, 3, 5, -1, 6, 2};              // x and y of each key
//       keys.tcbs = {{}, {0.5, 0, 0}, {0, -1, 0}, {0, 0, 0.25}};  // tension, continuity, bias of each key
//
//       CurveRules<double> rules = rules_of<double>(Preset::tcb);
//       rules.end.rule = EndRule::zero;  // stop at the last key
//
//       const auto curve = Curve<double>::build(keys, rules);
//       if (!curve) {
//         std::printf("%s\n", curve.error().message().c_str());
//         return 1;
//       }
//       std::array<double, 2> position{}, velocity{};
//       for (int row = 0; row <= 8; ++row) {
//         const double t = 10 + row * 0.5;
//         curve->position(t, position);
//         curve->velocity(t, velocity);
//         std::printf("t %g: position %.4f %.4f, velocity %.4f %.4f\n", t, position[0], position[1], velocity[0],
//                     velocity[1]);
//       }
//       const double length = curve->length().value;
//       for (int part = 0; part <= 4; ++part) {
//         const double t = curve->at_length(length * part / 4, position);
//         std::printf("length %.4f: t %.4f, position %.4f %.4f\n", length * part / 4, t, position[0], position[1]);
//       }
//       const Segment<double> first = curve->segment(0);
//       std::printf("segment 0 leaves with tangent %.4f %.4f\n", first.cubics[0].out, first.cubics[1].out);
//
//       const auto closed = Curve<double>::build_closed(keys, rules, 5.0);  // back at the first key at t = 15
//       closed->position(14.5, position);
//       std::printf("closed, t 14.5: position %.4f %.4f\n", position[0], position[1]);
//
//       // The curve of a camera that turns: x, and a rotation as the quaternion x, y, z, w.
//       Keys<double> poses;
//       poses.channels = 5;
//       poses.times = {0.0, 1.0, 2.0, 4.0};
//       poses.positions = {0, 0, 0,   0, 1,    //
//                          1, 0, 0, 0.6, 0.8,  //
//                          3, 0, 0, 0.8, 0.6,  //
//                          0, 0, 0,   0, 1};   // the last key repeats the first one and so ends the period
//       CurveRules<double> turning = rules_of<double>(Preset::tcb);
//       turning.rotations = {{.channels = {1, 2, 3, 4}}};
//       const auto camera = Curve<double>::build_closed(poses, turning);
//       const Quaternion<double> q = camera->rotation(1.5);
//       const Vector3<double> w = camera->angular_velocity(1.5);
//       std::printf("camera, t 1.5: rotation %.4f %.4f %.4f %.4f, turning %.4f radians per unit of time around z\n",
//                   q.x, q.y, q.z, q.w, w[2]);
//
//       // The open curve once more, segment after segment.
//       CurveStream<double> stream;
//       for (std::size_t key = 0; key <= keys.size(); ++key) {
//         Keys<double> one;
//         if (key < keys.size()) append(one, keys, key, key + 1);
//         const auto window = key < keys.size() ? stream.push(one) : stream.finish();
//         const Segments<double> known = segments(window, rules);
//         for (std::size_t i = 0; i < known.size(); ++i) std::printf("a segment to x %.4f\n", known[i][0].p1);
//       }
//
//       keys.times[2] = 10.5;
//       std::printf("%s\n", Curve<double>::build(keys).error().message().c_str());
//     }
//
// A Curve<double> takes the compiler seconds. The target tcb::spline compiles it once for a program, and
// tcb::spline_header_only in each source. Without CMake, define TCB_SPLINE_CURVE_DOUBLE and compile curve_double.cpp,
// too, so that it is compiled once.
#pragma once

#include "tcb/spline/angle.hpp"
#include "tcb/spline/arc_inverse.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/build_error.hpp"
#include "tcb/spline/closing.hpp"
#include "tcb/spline/curve.hpp"
#include "tcb/spline/curve_keys.hpp"
#include "tcb/spline/curve_rules.hpp"
#include "tcb/spline/curve_stream.hpp"
#include "tcb/spline/derivatives.hpp"
#include "tcb/spline/double_double.hpp"
#include "tcb/spline/double_pair.hpp"
#include "tcb/spline/dual.hpp"
#include "tcb/spline/ease.hpp"
#include "tcb/spline/key.hpp"
#include "tcb/spline/keys.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/rotation_curve.hpp"
#include "tcb/spline/rotation_form.hpp"
#include "tcb/spline/rotation_notation.hpp"
#include "tcb/spline/rules.hpp"
#include "tcb/spline/scalar.hpp"
#include "tcb/spline/segment.hpp"
#include "tcb/spline/segment_length.hpp"
#include "tcb/spline/segments.hpp"
#include "tcb/spline/window.hpp"
#include "tcb/spline/window_segments.hpp"
