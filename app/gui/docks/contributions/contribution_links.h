#pragma once

#include <QObject>
#include <QPointF>
#include <map>

#include "app/gui/base/jobs/job.h"
#include "app/gui/docks/contributions/contribution_sheet.h"

namespace noonmark {

class ContributionsDock;
class EditTools;
class ViewPanel;
class Workbench;
struct SavedContent;

/// Asks what each building and tree takes from the displayed study or comparison, in the whole region or in
/// the place that is clicked, and connects the answer with the view: buildings are coloured by what they
/// take, a row selects its building or tree and a click on one its row. Attribution runs in a job that can be
/// stopped; answers are kept until the study changes.
class ContributionLinks final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    ContributionLinks(ContributionsDock& dock, Workbench& workbench, EditTools& tools, ViewPanel& panel);

    void choose(const std::string& place);  ///< of the project; empty: the whole region
    /// Selects the building or the tree with this id, and moves the view to it.
    void show(const QString& id);
    /// The answer shown, of a study; null: none, or it came with the study.
    [[nodiscard]] std::shared_ptr<const PlaceContributions> shown() const;
    /// One of the dates of sun by place: contributions are of that day; none: of the period.
    void setDate(std::optional<std::size_t> date);
    [[nodiscard]] JobSlot& working() { return working_; }

Q_SIGNALS:
    void dockRequested();  ///< a study with contributions has arrived: the dock should be visible

private:
    void connectDock();
    void connectView();
    void listPlaces();
    void follow();
    void refresh();
    void showSheet();
    void showSun();
    void showStudy(const Study& study);
    void showSaved(const SavedContent& saved);
    void attribute();
    void attributeSun(std::size_t place);
    void take(const std::string& place, Result<PlaceContributions> made);
    void click(QPointF pixel);
    void mark(const ContributionRow& row);
    void goTo(const ContributionRow& row);
    void markSelected();
    void colour();
    void keepInSight();
    [[nodiscard]] ShownAs shownAs() const;
    [[nodiscard]] ContributionView view() const;
    [[nodiscard]] std::shared_ptr<const SunOfCities> sun() const;
    [[nodiscard]] std::optional<std::size_t> placeOfSun() const;
    [[nodiscard]] const ContributionTable* savedTable() const;
    [[nodiscard]] bool isOfShownTime(const StatedPeriod& period) const;
    [[nodiscard]] std::optional<CivilDate> dateOf(const SunOfCities& sun) const;
    [[nodiscard]] std::optional<Place> subject() const;
    [[nodiscard]] std::optional<std::uint32_t> indexOf(const Building& building) const;

    ContributionsDock& dock_;
    Workbench& workbench_;
    EditTools& tools_;
    ViewPanel& panel_;
    std::shared_ptr<const Study> study_;
    std::map<std::string, std::shared_ptr<const PlaceContributions>> known_;  ///< of study_, by place
    std::optional<std::size_t> date_;
    bool isJustChosen_ = false;  ///< the view is to show who shades the place that was chosen
    JobSlot working_;
};

/// The smallest place that contains a point; null: none does.
const Place* findPlaceAt(const std::vector<Place>& places, glm::dvec2 point);

}  // namespace noonmark
