#pragma once

#include <array>
#include <string>

namespace noonmark {

/// How sure a figure of a rule is.
enum class FigureStatus {
    verified,     ///< "V": read in the rule's text or on an official page
    reported,     ///< "R": reported by practice
    unconfirmed,  ///< "U": not checked against the rule's text
};

/// What a figure rests on. Every part of a rule carries one.
struct Evidence {
    FigureStatus status = FigureStatus::unconfirmed;
    std::string source;  ///< never empty
    bool operator==(const Evidence&) const = default;
};

/// Where on a window sunlight is taken.
enum class PanePlace {
    middle,      ///< middle of the pane
    sillMiddle,  ///< middle of its width, at the sill or above
    sillEnds,    ///< both ends of its width, at the sill or above: both must be in the sun at once
};

struct GlazingPoint {
    PanePlace place = PanePlace::middle;
    /// At the inside face of the wall: the sun must also pass through the opening, whose depth is that of the
    /// wall.
    bool insideFace = false;
    double aboveSillM = 0;   ///< of the sill's places: at least so high above the sill, 0 to 10
    double aboveFloorM = 0;  ///< and above the floor, 0 to 10
    bool operator==(const GlazingPoint&) const = default;
};

/// Sizes of windows whose file states none.
struct GlazingOpening {
    double sillM = 0.9;    ///< above the floor, 0 to 10; also of windows whose pane is known
    double widthM = 1.5;   ///< 0.1 to 20
    double heightM = 1.5;  ///< 0.1 to 20
    double wallM = 0.3;    ///< thickness of the wall, 0 to 3; also of windows whose pane is known
    Evidence evidence;
    bool operator==(const GlazingOpening&) const = default;
};

/// What windows are judged together.
enum class GlazingUnit {
    window,
    room,      ///< the windows of a room: the sun counts if it comes through one of them
    dwelling,  ///< the same of a dwelling
};

/// What a rule says about windows.
struct RuleGlazing {
    GlazingPoint point;
    GlazingOpening opening;
    double minSweepDeg = 0;  ///< least angle between the pane and the sun, seen from above, 0 to 89
    bool sweepOfOpening =
        false;  ///< that angle is at least arctan(thickness of the wall / width of the pane)
    GlazingUnit unit = GlazingUnit::window;
    bool operator==(const RuleGlazing&) const = default;
};

/// Azimuths from true north, clockwise from the first to the last, degrees, 0 to 360.
struct FacingRange {
    double fromDeg = 0, toDeg = 360;
    [[nodiscard]] bool holds(double azimuthDeg) const {
        return fromDeg <= toDeg ? azimuthDeg >= fromDeg && azimuthDeg <= toDeg
                                : azimuthDeg >= fromDeg || azimuthDeg <= toDeg;
    }
};

/// How many of a building's units must meet a criterion.
struct UnitShare {
    std::string name;
    std::string criterion;  ///< key
    double atLeast = 1;     ///< share of the units, 0 to 1
    Evidence evidence;
};

/// Probability that the sun shines, by month, 0 to 1.
struct SunshineTable {
    std::array<double, 12> byMonth{};
    Evidence evidence;
};

}  // namespace noonmark
