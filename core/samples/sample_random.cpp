#include "core/samples/sample_random.h"

#include <numbers>

namespace noonmark {

namespace {
// The finaliser of MurmurHash3 (Austin Appleby): neighbouring inputs give unrelated outputs.
std::uint32_t scrambled(std::uint32_t h) {
    h = (h ^ (h >> 16U)) * 0x85EBCA6BU;
    h = (h ^ (h >> 13U)) * 0xC2B2AE35U;
    return h ^ (h >> 16U);
}

std::uint32_t streamSeed(std::uint32_t seed, int column, int row) {
    return scrambled(scrambled(scrambled(seed) + std::uint32_t(column)) + std::uint32_t(row));
}
}  // namespace

SampleRandom::SampleRandom(std::uint32_t seed, int column, int row)
    : engine_(streamSeed(seed, column, row)) {}

double SampleRandom::uniform() { return double(engine_()) * 0x1p-32; }

double SampleRandom::logNormal(double median, double sigma) {
    double normal = -6;
    for (int i = 0; i < 12; ++i) normal += uniform();
    return median * sameExp(sigma * normal);
}

double sameExp(double x) {
    constexpr int halvings = 10;
    const double small = x / (1 << halvings);
    double sum = 1;
    for (int i = 8; i > 0; --i) sum = 1 + sum * small / i;
    for (int i = 0; i < halvings; ++i) sum *= sum;
    return sum;
}

SineCosine sameSineCosine(double turns) {
    // Taylor's series for an eighth of the angle, then doubled three times.
    const double angle = turns * std::numbers::pi / 4;
    double sine = 1, cosine = 1;
    for (int i = 18; i > 1; i -= 2) {
        sine = 1 - sine * angle * angle / (i * (i + 1));
        cosine = 1 - cosine * angle * angle / (i * (i - 1));
    }
    sine *= angle;
    for (int i = 0; i < 3; ++i) {
        const double doubled = 2 * sine * cosine;
        cosine = 1 - 2 * sine * sine;
        sine = doubled;
    }
    return {sine, cosine};
}

}  // namespace noonmark
