#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTreeView>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/places/places_dock.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/gui/session/study/region_text.h"
#include "app/report/maps/style.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/study/by_place/sun_by_place.h"

// What the view shows of the places: their colours, legend, error and what lies under the pointer.
namespace noonmark {

namespace {

// Grey without a cell.
QColor colourOf(const ColourScale& scale, double hours) {
    constexpr QColor withoutCell{0xa8, 0xa8, 0xa8};
    if (std::isnan(hours)) return withoutCell;
    const bool ofChange = scale.of == ColourScale::Of::change;
    return toColour(scale.colourOf(ofChange ? hours * minutesPerHour : hours));
}

}  // namespace

ColourScale PlacesDock::scaleOf(const ShownSun& shown) const {
    if (shown.what == ShownSun::What::change) return makePlaceChangeScale(colours_);
    std::vector<double> hours;
    for (std::size_t i = 0; i < model_->sun()->baseline.places.size(); ++i)
        hours.push_back(model_->hoursOf(i, shown));
    return makeThresholdScale(colours_, threshold_->value(), hours);
}

// Of what colours the places, so that nobody takes it for exact; empty: not measured.
QString PlacesDock::describeError(const ShownSun& shown) const {
    using What = ShownSun::What;
    const std::string_view quantity = shown.what == What::period ? "place_mean"
                                      : shown.what == What::date ? "place_date"
                                                                 : "place_change";
    const SunByPlace& sun = shownCity(*model_->sun());
    const std::string of =
        shown.what == What::date ? formatText(sun.settings.dates[shown.date]) : std::string();
    for (const ShownError& error : sun.errors)
        if (error.facts.key == quantity && error.of == of)
            return tr("Measured error against rays: %1").arg(sentenceText(describe(error)));
    return {};
}

void PlacesDock::colour() {
    view_.reset();
    if (const auto& sun = model_->sun()) {
        const ShownSun what = shown();
        std::vector<QColor> colours;
        const ColourScale scale = scaleOf(what);
        for (std::size_t i = 0; i < sun->baseline.places.size(); ++i)
            colours.push_back(colourOf(scale, model_->hoursOf(i, what)));
        model_->setColours(std::move(colours));
        view_ = std::make_shared<const PlaceView>(makeView(shownCity(*sun).name));
    }
    table_->viewport()->update();
    enableThreshold();
    describeCount();
    Q_EMIT viewChanged();
}

// The places of one of the cities that were measured.
PlaceView PlacesDock::makeView(const std::string& scenario) const {
    const auto& sun = model_->sun();
    const ShownSun what = shown();
    const ColourScale scale = scaleOf(what);
    std::vector<GroundPicture::Pixel> pixels;
    for (std::size_t i = 0; i < sun->baseline.places.size(); ++i)
        pixels.push_back(pixelOf(colourOf(scale, hoursOf(*sun, scenario, i, what))));
    return {picture_.coloured(pixels),
            legendOf(scaleAsShown(scale, what), what),
            note_.isEmpty() ? describeError(what) : note_,
            outdated_,
            threshold_->value(),
            model_->showsSun(what) ? ShownAs::sun : ShownAs::shadow,
            TreeColumns(trees_->currentData().toInt()),
            [this, what, scenario](glm::dvec2 point) { return describeAt(point, what, scenario); },
            [this, what](const std::string& other) -> std::shared_ptr<const PlaceView> {
                if (!model_->sun() || !isMeasured(*model_->sun(), other, what)) return nullptr;
                return std::make_shared<const PlaceView>(makeView(other));
            }};
}

// The same colours for the same places: less sun is more shadow.
ColourScale PlacesDock::scaleAsShown(ColourScale scale, const ShownSun& shown) const {
    if (model_->showsSun(shown)) return scale;
    const bool ofChange = shown.what == ShownSun::What::change;
    const auto asShown = [&](double one) {
        return ofChange ? -one : std::max(0.0, std::round(model_->shownOf(one, shown)));
    };
    std::swap(scale.low, scale.high);
    for (double* end : {&scale.low, &scale.high}) *end = asShown(*end);
    std::ranges::reverse(scale.breaks);
    for (double& one : scale.breaks) one = asShown(one);
    scale.reversed = !scale.reversed;
    scale.tick = (scale.high - scale.low) / 4;
    return scale;
}

Legend PlacesDock::legendOf(const ColourScale& scale, const ShownSun& shown) const {
    const bool isSun = model_->showsSun(shown);
    Legend legend{
        isSun ? QStringLiteral(NM_TEXT("Sun by place")) : QStringLiteral(NM_TEXT("Shadow by place")),
        isSun ? QStringLiteral(NM_TEXT("hours of sun a day"))
              : QStringLiteral(NM_TEXT("minutes of shadow a day"))};
    if (scale.of == ColourScale::Of::change) {
        legend.title = isSun ? QStringLiteral(NM_TEXT("Change of sun by place"))
                             : QStringLiteral(NM_TEXT("Change of shadow by place"));
        legend.unit = isSun ? QStringLiteral(NM_TEXT("minutes of sun a day"))
                            : QStringLiteral(NM_TEXT("minutes of shadow a day"));
    }
    legend.scale = {scale.high, scale.tick};
    legend.colours = scale;
    return legend;
}

QString PlacesDock::describeAt(glm::dvec2 point, const ShownSun& shown, const std::string& scenario) const {
    const auto place = picture_.placeAt(point);
    if (!place || !model_->sun()) return {};
    const QString name = placeName(model_->sun()->baseline.places[*place].name);
    const double hours = hoursOf(*model_->sun(), scenario, *place, shown);
    if (std::isnan(hours)) return tr("%1: no cell on open ground").arg(name);
    if (!model_->showsSun(shown)) {
        const QString minutes = groupDigits(std::abs(model_->shownOf(hours, shown)));
        if (shown.what != ShownSun::What::change) return tr("%1: %2 min of shadow a day").arg(name, minutes);
        return hours < 0 ? tr("%1: %2 min of shadow a day more").arg(name, minutes)
                         : tr("%1: %2 min of shadow a day less").arg(name, minutes);
    }
    if (shown.what == ShownSun::What::change)
        return hours < 0 ? tr("%1: %2 min of sun a day less").arg(name, groupDigits(-hours * 60))
                         : tr("%1: %2 min of sun a day more").arg(name, groupDigits(hours * 60));
    return tr("%1: %2 h of sun a day").arg(name, groupDigits(hours, 2));
}

}  // namespace noonmark
