#include "app/gui/docks/places/place_links.h"

#include "app/gui/docks/places/places_dock.h"
#include "app/gui/docks/results/result_display.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/questions/saved_question.h"

namespace noonmark {

namespace {

bool isAged(const std::shared_ptr<const Answer>& answer) {
    const auto saved = contentOf<SavedContent>(answer);
    return saved && !saved->upToDate();
}

}  // namespace

PlaceLinks::PlaceLinks(Workbench& workbench, const ResultDisplay& display, PlacesDock& dock, ViewPanel& panel)
    : workbench_(workbench), dock_(dock), panel_(panel) {
    connect(&display, &ResultDisplay::updated, this, &PlaceLinks::follow);
    connect(&workbench_, &Workbench::measuredUpdated, this, &PlaceLinks::follow);
    connect(&workbench_, &Workbench::answered, this, [this] {
        follow();
        if (sunOf(workbench_.answer())) Q_EMIT dockRequested();
    });
    connect(&workbench_, &Workbench::projectOpened, this, [this] {
        if (!isDisplayed_) kept_ = {};
        follow();
    });
    connect(&dock_, &PlacesDock::returnRequested, this, &PlaceLinks::showKept);
    connect(&dock_, &PlacesDock::viewChanged, this, &PlaceLinks::paint);
    connect(&panel_.legend(), &LegendStrip::choiceChanged, this,
            [this] { dock_.setColours(panel_.legend().choice()); });
    connect(&panel_.legend(), &LegendStrip::placesShownChanged, this,
            [this] { dock_.setShown(panel_.legend().shownOfPlaces()); });
    connect(&dock_, &PlacesDock::highlighted, this, [this](std::size_t place) {
        panel_.highlightPlace(nameOf(place));
        Q_EMIT chosen(place);
    });
    connect(&dock_, &PlacesDock::thresholdChosen, &workbench_, &Workbench::setEnough);
    connect(&dock_, &PlacesDock::goToRequested, this,
            [this](std::size_t place) { Q_EMIT placeRequested(nameOf(place)); });
    connect(&dock_, &PlacesDock::contributorsRequested, this,
            [this](std::size_t place) { Q_EMIT contributorsRequested(nameOf(place)); });
    connect(&panel_.navigator(), &ViewNavigator::clicked, this, &PlaceLinks::click);
}

// The view forgets what it shows with each city, so it is shown again.
void PlaceLinks::follow() {
    const auto past = workbench_.answer() ? nullptr : workbench_.past();
    const auto answer = past ? past : workbench_.answer();
    const auto sun = sunOf(answer);
    isDisplayed_ = sun != nullptr;
    if (sun) keep(sun);
    const bool isKeptAged = kept_.measured && workbench_.isOutdated(*kept_.measured);
    const bool placesChanged = !past && workbench_.havePlacesChanged();
    const bool outdated = sun ? past || placesChanged || isAged(answer) : isKeptAged;
    dock_.setAside(isDisplayed_ || !kept_.sun ? QString() : nameOfKept());
    const QString why = placesChanged ? tr("Outdated: places have changed")
                                      : tr("Outdated: buildings, trees or places have changed");
    dock_.show(kept_.sun, outdated ? why : QString(), outdated);
    paint();
}

void PlaceLinks::paint() { panel_.results().setPlaces(isDisplayed_ ? dock_.view() : nullptr); }

void PlaceLinks::keep(std::shared_ptr<const SunOfCities> sun) {
    kept_ = {std::move(sun), workbench_.measuredShown(), workbench_.savedName()};
}

QString PlaceLinks::nameOfKept() const {
    if (kept_.measured) return shownName(*kept_.measured);
    const auto result = findResult(workbench_.session().project(), kept_.saved);
    return result ? shownName(*result) : QString::fromStdString(kept_.saved);
}

void PlaceLinks::showKept() {
    if (kept_.measured) return workbench_.showMeasured(*kept_.measured);
    if (!kept_.saved.empty()) workbench_.showSaved(kept_.saved);
}

const std::string& PlaceLinks::nameOf(std::size_t place) const {
    return dock_.model().sun()->baseline.places[place].name;
}

void PlaceLinks::click(QPointF pixel) {
    if (panel_.drawing() || !panel_.results().showsPlaces()) return;
    const auto pick = panel_.navigator().pickAt(pixel);
    if (!pick || pick->building) return;
    if (const auto place = dock_.placeAt({pick->position.x, pick->position.y})) dock_.select(*place);
}

}  // namespace noonmark
