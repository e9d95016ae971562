#include "core/measures/shown_quantity.h"

#include <algorithm>

#include "core/describe/shown_as.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

struct QuantityWords {
    ShownAs as;
    std::string_view title, unit, shortUnit;
};

constexpr QuantityWords quantityWords[] = {
    {ShownAs::shadow, NM_TEXT("Gross shadow"), NM_TEXT("minutes in shadow a day"), "min"},
    {ShownAs::sun, NM_TEXT("Hours of sun"), NM_TEXT("hours of sun a day"), "h"},
    {ShownAs::share, NM_TEXT("Share of the sunlit time"), NM_TEXT("% in the sun"), "%"},
};

const QuantityWords& wordsOf(ShownAs as) { return *std::ranges::find(quantityWords, as, &QuantityWords::as); }

double pctOf(double minutes, double sunlitMin) {
    return sunlitMin > 0 ? percentOfWhole * minutes / sunlitMin : 0;
}

}  // namespace

double ShownQuantity::of(double grossMin) const {
    const double sunMin = std::max(sunlitMin - grossMin, 0.0);  // NaN stays NaN
    if (as == ShownAs::sun) return sunMin / minutesPerHour;
    if (as == ShownAs::share) return pctOf(sunMin, sunlitMin);
    return grossMin;
}

double ShownQuantity::minutesOf(double value) const {
    if (as == ShownAs::sun) return sunlitMin - value * minutesPerHour;
    if (as == ShownAs::share) return sunlitMin * (1 - value / percentOfWhole);
    return value;
}

double ShownQuantity::ofChange(double grossMin) const { return isSun() ? -grossMin : grossMin; }

double ShownQuantity::ofError(double grossMin) const {
    if (as == ShownAs::sun) return grossMin / minutesPerHour;
    if (as == ShownAs::share) return pctOf(grossMin, sunlitMin);
    return grossMin;
}

std::string_view ShownQuantity::title() const { return wordsOf(as).title; }

std::string_view ShownQuantity::unit() const { return wordsOf(as).unit; }

std::string_view ShownQuantity::shortUnit() const { return wordsOf(as).shortUnit; }

}  // namespace noonmark
