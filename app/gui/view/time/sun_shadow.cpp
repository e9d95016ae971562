#include "app/gui/view/time/sun_shadow.h"

#include <numeric>

namespace noonmark {

namespace {

std::shared_ptr<const CasterFaces> facesOf(const City& city, const std::stop_token& stop) {
    std::vector<std::uint32_t> all(city.buildings.size());
    std::iota(all.begin(), all.end(), 0U);
    return std::make_shared<const CasterFaces>(makeCasterFaces(city, all, stop));
}

}  // namespace

void SunShadow::setCity(std::shared_ptr<const City> city) {
    if (city == city_) return;
    slot_.drop();
    city_ = std::move(city);
    faces_.reset();
    ask();
}

void SunShadow::look(const std::optional<SunView>& view) {
    view_ = view;
    if (!view_) {
        slot_.drop();
        if (map_) {
            map_.reset();
            Q_EMIT changed();
        }
        return;
    }
    waiting_ = true;
    if (!slot_.busy()) ask();
}

void SunShadow::ask() {
    if (!city_ || !view_) return;
    waiting_ = false;
    slot_.start<Drawn>(
        tr("Drawing the shadow"),
        [city = city_, faces = faces_, view = *view_](Progress&,
                                                      const std::stop_token& stop) -> Result<Drawn> {
            Drawn drawn{faces ? faces : facesOf(*city, stop), nullptr};
            if (stop.stop_requested()) return cancelled();
            drawn.map = std::make_shared<const SunDepthMap>(
                drawSunDepths(*drawn.faces, view.towardsSun, view.space, view.size, stop));
            if (stop.stop_requested()) return cancelled();
            return drawn;
        },
        [this](const Result<Drawn>& drawn) { take(drawn); });
}

void SunShadow::take(const Result<Drawn>& drawn) {
    if (!drawn || !view_) return;
    faces_ = drawn->faces;
    map_ = drawn->map;
    Q_EMIT changed();
    if (waiting_) ask();
}

}  // namespace noonmark
