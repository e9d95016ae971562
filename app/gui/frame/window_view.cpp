#include "app/gui/frame/window_view.h"

#include <QSettings>
#include <glm/common.hpp>

#include "app/gui/docks/review/review_session.h"
#include "app/gui/frame/actions/view_actions.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/view_presets.h"

namespace noonmark {

namespace {

const QString shownKey = QStringLiteral("legendShow");

ShownAs lastShown(const QSettings& settings) {
    const std::string key = settings.value(shownKey).toString().toStdString();
    return findChoice(shownChoices(), key).value_or(ShownAs::shadow);
}

// The region with ground around it; of a city that is smaller than that only the city with some ground.
Box2 firstSight(const Region& region, const Box2& city) {
    const Box2 wide = boxAround(region);
    const glm::vec2 border = (city.high - city.low) * 0.2F;
    const Box2 seen{glm::max(wide.low, city.low - border), glm::min(wide.high, city.high + border)};
    return seen.empty() ? wide : seen;
}

}  // namespace

void WindowView::rememberShown() {
    const std::string_view key = keyOf(shownChoices(), panel_.legend().choice().show);
    settings_.setValue(shownKey, QString::fromUtf8(key.data(), qsizetype(key.size())));
}

std::map<std::string, std::string> WindowView::toSave() const {
    const ProjectSession& session = workbench_.session();
    ViewState state{.camera = panel_.view().pose(),
                    .section = panel_.view().section(),
                    .mode = mode_.mode(),
                    .measure = panel_.legend().measure(),
                    .changeScale = panel_.legend().changeScale(),
                    .legend = panel_.legend().choice(),
                    .scenario = session.scenario(),
                    .baseline = session.baseline(),
                    .study = workbench_.document().settings(),
                    .elements = workbench_.document().elements(),
                    .review = formatText(review_.choice())};
    if (const auto answer = workbench_.answer(); answer && answer->question().ofRun) {
        state.answer = answer->as<ImpactAnswer>() ? "comparison" : "study";
        state.answerSeconds = workbench_.answerSeconds();
    }
    if (const auto measured = workbench_.measuredShown()) state.shown = measured->name();
    return textsOf(state);
}

void WindowView::restore() { restore(workbench_.openedView()); }

void WindowView::restore(const ViewState& view) {
    review_.restore(view.review);
    if (workbench_.session().file() || &view != &workbench_.openedView()) {
        mode_.setMode(view.mode);
        panel_.legend().setMeasure(view.measure);
        panel_.legend().setChoice(view.legend);
    } else {
        panel_.legend().setChoice({.show = lastShown(settings_)});
    }
    panel_.legend().setChangeScale(view.changeScale);
    panel_.section().set(view.section);
    if (view.camera)
        panel_.view().setPose(*view.camera);
    else
        panel_.navigator().showSlanting(
            firstSight(workbench_.document().settings().region, panel_.view().mainBounds().box));
}

}  // namespace noonmark
