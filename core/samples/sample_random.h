#pragma once

#include <cstdint>
#include <random>

namespace noonmark {

/// Random numbers for the samples, identical on every machine: the C++ standard leaves the distributions of
/// <random>, and the last bits of std::exp and std::cos, to the implementation. One stream per block, so that
/// a block does not depend on the number of other blocks.
class SampleRandom {
public:
    SampleRandom(std::uint32_t seed, int column, int row);

    /// 0 (included) to 1 (excluded), in steps of 2^-32.
    double uniform();
    double between(double low, double high) { return low + (high - low) * uniform(); }
    bool chance(double probability) { return uniform() < probability; }

    /// Log-normal; the underlying normal is a sum of twelve uniform numbers, so it ends at 6 sigma.
    double logNormal(double median, double sigma);

private:
    std::mt19937 engine_;
};

/// e^x for |x| <= 20 to 12 digits, computed with + * and / only: the same bits on every machine.
double sameExp(double x);

struct SineCosine {
    double sine;
    double cosine;
};
/// Sine and cosine of a share of the full turn, -1 to 1, to 12 digits; the same bits on every machine.
SineCosine sameSineCosine(double turns);

}  // namespace noonmark
