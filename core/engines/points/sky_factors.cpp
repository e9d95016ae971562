#include "core/engines/points/sky_factors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace noonmark {

namespace {

// The azimuth's part of the integrals up to an altitude, for a surface whose normal has the component `up`
// and, at this azimuth, `towards`: the antiderivatives of (up sin + towards cos) cos, plain and times (1 + 2
// sin) / 3.
struct SkyIntegral {
    double even = 0;
    double overcast = 0;

    static SkyIntegral upTo(double altitude, double up, double towards) {
        const double sine = std::sin(altitude), cosine = std::cos(altitude);
        const double level = altitude / 2 + sine * cosine / 2;
        return {up * sine * sine / 2 + towards * level,
                (up * (sine * sine / 2 + 2 * sine * sine * sine / 3) +
                 towards * (level - 2 * cosine * cosine * cosine / 3)) /
                    3};
    }
    void add(const SkyIntegral& more, double weight) {
        even += weight * more.even;
        overcast += weight * more.overcast;
    }
};

// The altitudes that the surface faces are visible; what is behind its plane is hidden like everything else.
std::vector<HiddenAltitudes> hiddenFrom(const Skyline& skyline, double azimuth, double up, double towards) {
    std::vector<HiddenAltitudes> hidden = skyline.hiddenAt(azimuth);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double upright = 1e-7;
    if (std::abs(up) < upright) {
        if (towards <= 0) hidden.push_back({0, infinite});
    } else if (up > 0) {
        if (towards < 0) hidden.push_back({0, -towards / up});
    } else {
        hidden.push_back({std::max(0.0, towards / -up), infinite});
    }
    joinOverlaps(hidden);
    return hidden;
}

SkyIntegral integrateAltitudes(const Skyline& skyline, double azimuth) {
    const glm::dvec3 normal(skyline.normal());
    const double towards = normal.x * std::sin(azimuth) + normal.y * std::cos(azimuth);
    SkyIntegral visible;
    visible.add(SkyIntegral::upTo(std::numbers::pi / 2, normal.z, towards), 1);
    visible.add(SkyIntegral::upTo(0, normal.z, towards), -1);
    for (const HiddenAltitudes& hidden : hiddenFrom(skyline, azimuth, normal.z, towards)) {
        visible.add(SkyIntegral::upTo(std::atan(hidden.highTan), normal.z, towards), -1);
        visible.add(SkyIntegral::upTo(std::atan(hidden.lowTan), normal.z, towards), 1);
    }
    return visible;
}

SkyIntegral integrateBetween(const Skyline& skyline, double from, double to) {
    constexpr std::array place{0.0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                               -0.9061798459386640};
    constexpr std::array weight{0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                                0.2369268850561891, 0.2369268850561891};
    SkyIntegral sum;
    for (std::size_t i = 0; i < place.size(); ++i)
        sum.add(integrateAltitudes(skyline, (from + to) / 2 + place[i] * (to - from) / 2),
                weight[i] * (to - from) / 2);
    return sum;
}

}  // namespace

SkyFactors computeSkyFactors(const Skyline& skyline) {
    constexpr double widest = std::numbers::pi / 180;
    const std::vector<double> breaks = skyline.breaks();
    SkyIntegral sum;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double width = breaks[i + 1] - breaks[i];
        const int parts = std::max(1, int(std::ceil(width / widest)));
        for (int part = 0; part < parts; ++part)
            sum.add(integrateBetween(skyline, breaks[i] + width * part / parts,
                                     breaks[i] + width * (part + 1) / parts),
                    1);
    }
    const double openOvercast =
        7 * std::numbers::pi / 9;  // of a level surface, in units of the zenith's brightness
    return {sum.even / std::numbers::pi, 100 * sum.overcast / openOvercast};
}

}  // namespace noonmark
