#include "app/gui/docks/contributions/contribution_links.h"

#include <algorithm>
#include <utility>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/docks/contributions/contributions_dock.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/study/region_text.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/input/all_engines.h"
#include "app/questions/saved_question.h"
#include "app/report/maps/style.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

// Of the ground that is shown around what a row is about.
constexpr float aroundM = 80;
constexpr float aroundTreeM = 40;

glm::dvec2 middleOf(const Box2& box) { return (glm::dvec2(box.low) + glm::dvec2(box.high)) * 0.5; }

// The place and the buildings that take nine tenths of its shadow; those that take little may stand far away.
Box2 boxOfShaders(const Place& place, const std::vector<ContributionRow>& rows) {
    constexpr double shownShare = 0.9;
    Box2 box = bounds(place);
    double share = 0;
    for (const ContributionRow& row : rows) {
        if (share >= shownShare) break;
        share += row.share;
        if (!row.building) continue;
        const Box2 one = bounds(*row.building);
        box = {glm::min(box.low, one.low), glm::max(box.high, one.high)};
    }
    return box;
}

bool isInSight(const CityView& view, const City& city, const Box2& box) {
    const ViewLens lens = view.lens();
    for (const glm::vec2 corner :
         {box.low, glm::vec2(box.high.x, box.low.y), box.high, glm::vec2(box.low.x, box.high.y)}) {
        const glm::dvec2 at(corner);
        const auto pixel = pixelOf(view.pose(), lens, {at.x, at.y, double(groundAt(city, at))});
        if (!pixel || pixel->x < 0 || pixel->y < 0 || pixel->x > lens.widthPx || pixel->y > lens.heightPx)
            return false;
    }
    return true;
}

}  // namespace

const Place* findPlaceAt(const std::vector<Place>& places, glm::dvec2 point) {
    const Place* smallest = nullptr;
    for (const Place& place : places) {
        const auto holds = [&](const Footprint& polygon) { return contains(polygon, point); };
        if (std::ranges::none_of(place.polygons, holds)) continue;
        if (smallest == nullptr || area(place) < area(*smallest)) smallest = &place;
    }
    return smallest;
}

ContributionLinks::ContributionLinks(ContributionsDock& dock, Workbench& workbench, EditTools& tools,
                                     ViewPanel& panel)
    : dock_(dock), workbench_(workbench), tools_(tools), panel_(panel) {
    workbench_.setPlaceShown([this] { return shown(); });
    connectDock();
    connectView();
    connect(&workbench_, &Workbench::answered, this, &ContributionLinks::follow);
    connect(&workbench_, &Workbench::answerUpdated, this, &ContributionLinks::refresh);
    connect(&workbench_, &Workbench::cityShown, this, &ContributionLinks::follow);
    connect(&workbench_.session(), &ProjectSession::changed, this, &ContributionLinks::listPlaces);
    connect(&workbench_.session(), &ProjectSession::baselineChanged, this, &ContributionLinks::follow);
}

void ContributionLinks::connectDock() {
    dock_.progress().follow(working_);
    connect(&dock_, &ContributionsDock::subjectChosen, this, &ContributionLinks::choose);
    connect(&dock_, &ContributionsDock::attributionRequested, this, &ContributionLinks::attribute);
    connect(&dock_, &ContributionsDock::coloursChanged, this, &ContributionLinks::colour);
    connect(&dock_, &ContributionsDock::shownChanged, this, &ContributionLinks::colour);
    connect(&dock_, &ContributionsDock::highlighted, this, &ContributionLinks::mark);
    connect(&dock_, &ContributionsDock::goToRequested, this, &ContributionLinks::goTo);
}

void ContributionLinks::connectView() {
    connect(&panel_.navigator(), &ViewNavigator::clicked, this, &ContributionLinks::click);
    connect(&tools_.building(), &BuildingEditing::selectionChanged, this, &ContributionLinks::markSelected);
    connect(&panel_.legend(), &LegendStrip::shownChosen, this, &ContributionLinks::refresh);
    connect(&panel_.legend(), &LegendStrip::choiceChanged, this,
            [this, before = TreeColumns::without]() mutable {
                const TreeColumns now = panel_.legend().choice().trees;
                if (std::exchange(before, now) != now) refresh();
            });
}

void ContributionLinks::listPlaces() {
    QStringList names;
    for (const Place& place : workbench_.session().project().places)
        names << QString::fromStdString(place.name);
    names.sort(Qt::CaseInsensitive);
    dock_.setPlaces(names);
}

// Answers about buildings that have changed since are dropped.
void ContributionLinks::follow() {
    const auto study = workbench_.study();
    if (study != study_) {
        study_ = study;
        known_.clear();
        working_.drop();
        if (study_ && study_->settings.contributions) Q_EMIT dockRequested();
    }
    if (!dock_.subject().empty() && !subject()) dock_.setSubject({});  // it is gone, or of another project
    refresh();
}

// The places of the answer shown, where it is about places; null: it is not, or it was saved.
std::shared_ptr<const SunOfCities> ContributionLinks::sun() const {
    return workbench_.answerAs<SunOfCities>();
}

std::optional<std::size_t> ContributionLinks::placeOfSun() const {
    const auto places = sun();
    if (!places) return std::nullopt;
    const auto& all = places->baseline.places;
    const auto at = std::ranges::find(all, dock_.subject(), &Place::name);
    return at == all.end() ? std::nullopt : std::optional(std::size_t(at - all.begin()));
}

const ContributionTable* ContributionLinks::savedTable() const {
    if (!workbench_.answer() || dock_.subject().empty()) return nullptr;
    const auto& all = workbench_.answer()->ofPlaces();
    const auto at = std::ranges::find_if(all, [this](const ContributionTable& of) {
        return of.place == dock_.subject() && isOfShownTime(of.period);
    });
    return at == all.end() ? nullptr : &*at;
}

// A saved answer about places states its dates, not its period.
bool ContributionLinks::isOfShownTime(const StatedPeriod& period) const {
    const auto shown = sunOf(workbench_.answer());
    if (!shown || period.words.empty()) return true;
    const SunByPlaceSettings& settings = shown->baseline.settings;
    const auto date = dateOf(*shown);
    if (sun()) return period.words == formatText(periodOf(settings, date));
    if (period.asked) return !date || (period.asked->start == *date && period.asked->days == 1);
    return !date || period.words.starts_with(formatText(*date) + ", 1 day,");
}

std::optional<CivilDate> ContributionLinks::dateOf(const SunOfCities& sun) const {
    const auto& dates = sun.baseline.settings.dates;
    return date_ && *date_ < dates.size() ? std::optional(dates[*date_]) : std::nullopt;
}

void ContributionLinks::setDate(std::optional<std::size_t> date) {
    if (date == date_) return;
    date_ = date;
    if (sunOf(workbench_.answer()) && dock_.isInFront())
        choose(std::string(dock_.subject()));
    else
        refresh();
}

std::optional<Place> ContributionLinks::subject() const {
    if (const auto place = placeOfSun()) return sun()->baseline.places[*place];
    if (dock_.subject().empty()) {
        if (!study_) return std::nullopt;
        return Place{study_->settings.region.name, PlaceKind::other, study_->settings.region.polygons, {}};
    }
    auto place = findPlace(workbench_.session().project(), dock_.subject());
    return place ? std::optional(*std::move(place)) : std::nullopt;
}

void ContributionLinks::refresh() {
    showSheet();
    keepInSight();
}

void ContributionLinks::showSheet() {
    if (const auto comparison = workbench_.answerAs<ImpactAnswer>(); comparison && workbench_.city()) {
        const auto place = dock_.subject().empty() ? std::nullopt : subject();
        return dock_.show(makeContributionSheet(*comparison, workbench_.city()->city(),
                                                place ? &*place : nullptr, shownAs()));
    }
    if (const auto saved = workbench_.answerAs<SavedContent>()) return showSaved(*saved);
    if (sun()) return showSun();
    if (study_) return showStudy(*study_);
    if (workbench_.past())
        return dock_.explain(
            tr("Buildings or trees have changed since the last answer. Run it again (Ctrl+R), then "
               "click a place in the view to see which buildings shade it."));
    dock_.explain(
        tr("No study yet. Run one (Ctrl+R), then click a place in the view to see which buildings "
           "shade it."));
}

// Where the legend shows no trees, those with their seasons are listed: they are part of who shades it.
ContributionView ContributionLinks::view() const {
    const TreeColumns trees = panel_.legend().choice().trees;
    ContributionView view{shownAs(), trees == TreeColumns::without ? TreeColumns::seasonal : trees};
    if (const auto place = dock_.subject().empty() ? std::nullopt : subject())
        view.from = middleOf(bounds(*place));
    return view;
}

// Sun by place has a switch of its own.
ShownAs ContributionLinks::shownAs() const {
    return sunOf(workbench_.answer()) ? panel_.legend().shownOfPlaces() : panel_.legend().choice().show;
}

void ContributionLinks::showSun() {
    if (const ContributionTable* known = savedTable(); known != nullptr && workbench_.city())
        return dock_.show(makeContributionSheet(*known, workbench_.city()->city(), view()));
    if (placeOfSun())
        return dock_.explain(tr("What the buildings take from this place has not been computed yet."), true);
    dock_.explain(
        tr("Choose a place of the table, or click one in the view, to see which buildings shade "
           "it."));
}

void ContributionLinks::showStudy(const Study& study) {
    if (const auto answer = shown()) return dock_.show(makeContributionSheet(study, *answer, view()));
    if (const ContributionTable* known = savedTable())
        return dock_.show(makeContributionSheet(*known, study.city, view()));
    if (!dock_.subject().empty())
        return dock_.explain(tr("What the buildings take from this place has not been computed yet."), true);
    if (study.settings.contributions && study.breakdown)
        return dock_.show(makeContributionSheet(
            study, *study.breakdown, listContributions(study.city, *study.breakdown, study.sun.dayCount()),
            view(), listTreeContributions(study)));
    dock_.explain(tr("Click a place in the view to see which buildings shade it, or attribute the shadow of "
                     "the whole region."),
                  true, makeMonthBars(study));
}

// What a place gets is computed from a study, which the project file does not hold.
void ContributionLinks::showSaved(const SavedContent& saved) {
    if (const ContributionTable* known = savedTable(); known != nullptr && workbench_.city())
        return dock_.show(makeContributionSheet(*known, workbench_.city()->city(), view()));
    const auto* study = saved.as<SavedStudy>();
    if (study && study->contributions && dock_.subject().empty() && workbench_.city())
        return dock_.show(makeContributionSheet(*study, workbench_.city()->city(), view()));
    dock_.explain(tr("A saved result holds what buildings take from its whole region, if that was asked for. "
                     "Of places it holds those that were attributed before it was saved."),
                  false, study ? makeMonthBars(study->months, study->start, study->field.days) : Bars());
}

std::shared_ptr<const PlaceContributions> ContributionLinks::shown() const {
    const auto found = known_.find(dock_.subject());
    return found == known_.end() ? nullptr : found->second;
}

// A place is attributed at once; the whole region, which may take long, when its button is pressed.
void ContributionLinks::choose(const std::string& place) {
    // Another date of the same place leaves the camera.
    isJustChosen_ = !place.empty() && (isJustChosen_ || place != dock_.subject());
    dock_.setSubject(place);
    panel_.highlightPlace(place);
    working_.drop();
    refresh();
    const bool other = workbench_.answerAs<ImpactAnswer>() || workbench_.answerAs<SavedContent>();
    if (other || place.empty() || savedTable() != nullptr) return;
    if (sun() ? placeOfSun().has_value() : study_ && !shown()) attribute();
}

void ContributionLinks::attributeSun(std::size_t place) {
    working_.start<PlaceContributions>(
        tr("Attributing the shadow of %1").arg(placeName(dock_.subject())),
        [places = sun(), place, date = dateOf(*sun()) ? date_ : std::nullopt](Progress& progress,
                                                                              std::stop_token stop) {
            return computePlaceContributions(*places, place, date, progress, std::move(stop),
                                             enginesWith(places->baseline.settings.study.engine));
        },
        [this, places = sun()](Result<PlaceContributions> made) {
            if (!sun() || !haveSameShadow(*places, *sun())) return;
            if (!made)
                return isCancelled(made.error()) ? refresh() : dock_.explain(describeError(made.error()));
            workbench_.attachToAnswer(makeContributionTable(*made));
        });
}

void ContributionLinks::attribute() {
    if (const auto place = placeOfSun()) return attributeSun(*place);
    const auto place = subject();
    if (!study_ || !place) return;
    working_.start<PlaceContributions>(
        tr("Attributing the shadow of %1").arg(placeName(place->name)),
        [study = study_, place = *place](Progress& progress, std::stop_token stop) {
            return computePlaceContributions(*study, place, progress, std::move(stop),
                                             enginesWith(study->settings.engine));
        },
        [this, study = study_, name = dock_.subject()](Result<PlaceContributions> made) {
            if (study == study_) take(name, std::move(made));
        });
}

void ContributionLinks::take(const std::string& place, Result<PlaceContributions> made) {
    if (!made) return isCancelled(made.error()) ? refresh() : dock_.explain(describeError(made.error()));
    known_[place] = std::make_shared<const PlaceContributions>(*std::move(made));
    if (!place.empty() && workbench_.answerAs<Study>() == study_)
        workbench_.attachToAnswer(makeContributionTable(*known_[place]));
    refresh();
}

void ContributionLinks::click(QPointF pixel) {
    if (!dock_.isInFront() || panel_.drawing() || !workbench_.city()) return;
    const auto pick = panel_.navigator().pickAt(pixel);
    if (!pick || pick->building) return;
    const auto measured = sun();
    const auto& places = measured ? measured->baseline.places : workbench_.session().project().places;
    const Place* place = findPlaceAt(places, glm::dvec2(pick->position));
    if (place != nullptr) choose(place->name);
}

void ContributionLinks::show(const QString& id) {
    if (!workbench_.city()) return;
    ContributionRow row{.name = id};
    const auto& buildings = workbench_.city()->city().buildings;
    const auto found = std::ranges::find(buildings, id.toStdString(),
                                         [](const auto& one) -> const std::string& { return one->sourceId; });
    if (found != buildings.end())
        row.building = *found;
    else
        row.tree = id.toStdString();
    mark(row);
    goTo(row);
}

// A tree is chosen before the building is let go: what follows the selection finds its row.
void ContributionLinks::mark(const ContributionRow& row) {
    const auto building = row.building ? indexOf(*row.building) : std::nullopt;
    if (building && tools_.building().selected() != building) tools_.building().select(building);
    if (row.tree.empty()) return;
    tools_.trees().choose(row.tree);
    if (!tools_.building().all().empty()) tools_.building().select(std::nullopt);
}

// Once for each place that is chosen, as soon as its rows are there.
void ContributionLinks::keepInSight() {
    const auto place = isJustChosen_ ? subject() : std::nullopt;
    const auto& rows = dock_.model().sheet().rows;
    if (!place || rows.empty() || !workbench_.city()) return;
    isJustChosen_ = false;
    const Box2 box = boxOfShaders(*place, rows);
    if (!isInSight(panel_.view(), workbench_.city()->city(), box))
        panel_.navigator().show({box.low - aroundM, box.high + aroundM});
}

void ContributionLinks::goTo(const ContributionRow& row) {
    const auto show = [this](const Box2& box, float marginM) {
        panel_.navigator().showSlanting({box.low - marginM, box.high + marginM});
    };
    if (row.building) return show(bounds(*row.building), aroundM);
    if (const auto tree = tools_.trees().findTree(row.tree))
        show({glm::vec2(tree->place), glm::vec2(tree->place)}, aroundTreeM);
}

std::optional<std::uint32_t> ContributionLinks::indexOf(const Building& building) const {
    if (!workbench_.city()) return std::nullopt;
    const auto& buildings = workbench_.city()->city().buildings;
    const auto found = std::ranges::find(buildings, &building, [](const auto& one) { return one.get(); });
    if (found == buildings.end()) return std::nullopt;
    return std::uint32_t(found - buildings.begin());
}

void ContributionLinks::markSelected() {
    const auto& trees = tools_.trees().chosenIds();
    if (tools_.building().all().empty() && trees.size() == 1) return dock_.selectTree(*trees.begin());
    const auto selected = tools_.building().selected();
    const bool known =
        selected && workbench_.city() && *selected < workbench_.city()->city().buildings.size();
    dock_.select(known ? workbench_.city()->city().buildings[*selected].get() : nullptr);
}

// Only buildings that still stand as they did.
void ContributionLinks::colour() {
    std::vector<OverlayBodies::Coloured> groups(contributionClasses.size());
    if (dock_.isInFront() && dock_.colours() && workbench_.city()) {
        std::vector<const Building*> standing;
        for (const auto& building : workbench_.city()->city().buildings) standing.push_back(building.get());
        std::ranges::sort(standing);
        for (const ContributionRow& row : dock_.model().sheet().rows)
            if (row.building && std::ranges::binary_search(standing, row.building.get()))
                groups[classOf(row.share)].some.buildings.push_back(row.building);
    }
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const QColor colour = toColour(contributionClasses[i].colour);
        groups[i].colour = {colour.redF(), colour.greenF(), colour.blueF()};
    }
    panel_.view().overlay().showColoured(groups);
}

}  // namespace noonmark
