#include "app/gui/view/compare/other_scenario.h"

#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"
#include "render/view/software_drawing.h"

namespace noonmark {

OtherScenario::OtherScenario(Workbench& workbench, ViewPanel& panel, QObject* parent)
    : QObject(parent), workbench_(workbench), panel_(panel) {
    // Queued: once the view has the city.
    connect(
        &workbench_, &Workbench::cityShown, this, [this] { start(); }, Qt::QueuedConnection);
    connect(&workbench_.session(), &ProjectSession::renamed, this,
            [this](ProjectPart part, const std::string& from, const std::string& to) {
                if (part == ProjectPart::scenario && name_ == from) name_ = to;
            });
}

void OtherScenario::show(const std::string& scenario) {
    name_ = scenario;
    start();
}

void OtherScenario::clear() {
    name_.clear();
    city_.reset();
    preparing_.drop();
    panel_.view().other().clear();
}

void OtherScenario::start() {
    const auto arrays = panel_.view().arrays();
    if (name_.empty() || !arrays) return;
    preparing_.drop();
    auto city = workbench_.session().cityOf(name_);
    if (!city) return take(nullptr, tl::make_unexpected(city.error()));
    if (*city == city_ && panel_.view().other().arrays() == arrays) return Q_EMIT changed();
    preparing_.start<Prepared>(
        tr("Showing %1").arg(QString::fromStdString(name_)),
        [city = *city, arrays](Progress&, const std::stop_token& stop) {
            return prepare(*city, *arrays, stop);
        },
        [this, city = *city, arrays](Result<Prepared> prepared) {
            if (arrays != panel_.view().arrays()) return start();
            take(city, std::move(prepared));
        });
}

Result<OtherScenario::Prepared> OtherScenario::prepare(const City& city, const CityArrays& arrays,
                                                       const std::stop_token& stop) {
    Prepared prepared{computeDifference(arrays, city), {}};
    if (!drawsInSoftware()) return prepared;
    auto scene = RayScene::over(city, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    prepared.scene = *std::move(scene);
    return prepared;
}

void OtherScenario::take(std::shared_ptr<const City> city, Result<Prepared> prepared) {
    if (!prepared) {
        clear();
        return Q_EMIT failed(prepared.error());
    }
    city_ = std::move(city);
    panel_.view().showOther(prepared->changes, std::move(prepared->scene), city_->buildings);
    Q_EMIT changed();
}

}  // namespace noonmark
