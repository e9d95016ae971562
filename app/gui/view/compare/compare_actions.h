#pragma once

#include <QCursor>
#include <QObject>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/base/jobs/job.h"
#include "core/base/result.h"
#include "core/engines/ray/ray_scene.h"
#include "render/scene/city_arrays.h"
#include "render/view/view_navigator.h"

class QComboBox;
class QLabel;
// Two scenarios in one view. CompareActions has the entries of the menu and decides what is shown;
// OtherScenario prepares the other scenario's city; CompareStrip names both above the view; DividerHandle
// drags the line between them.
class QAction;

namespace noonmark {

class ViewPanel;
class Workbench;

/// The scenario that the view compares the displayed one with. Its city is prepared in a job and shown as
/// CityView::other(); it is prepared again when the view gets other arrays.
class OtherScenario final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive this object.
    OtherScenario(Workbench& workbench, ViewPanel& panel, QObject* parent = nullptr);

    /// Shows a scenario, or existingCity, as it is now. changed() or failed() follows, at once if it is shown
    /// already.
    void show(const std::string& scenario);
    void clear();  ///< shows none, and frees its city

    [[nodiscard]] const std::string& name() const { return name_; }           ///< empty: none
    [[nodiscard]] std::shared_ptr<const City> city() const { return city_; }  ///< null: not shown yet
    [[nodiscard]] JobSlot& preparing() { return preparing_; }

Q_SIGNALS:
    void changed();  ///< city() is shown
    /// None is shown: the scenario was removed, memory ran out, or cancelled().
    void failed(noonmark::Error error);

private:
    struct Prepared {
        ArrayDifference changes;
        std::optional<RayScene> scene;            ///< where the processor draws
        std::shared_ptr<const CrownRays> crowns;  ///< likewise
    };
    /// `crowns`: of the displayed city.
    static Result<Prepared> prepare(const City& city, const CityArrays& arrays,
                                    std::shared_ptr<const CrownRays> crowns, const std::stop_token& stop);
    void start();
    void take(std::shared_ptr<const City> city, Result<Prepared> prepared);

    Workbench& workbench_;
    ViewPanel& panel_;
    std::string name_;
    std::shared_ptr<const City> city_;
    JobSlot preparing_;
};

class ProjectSession;

/// The strip above the view while it compares two scenarios: a list of the others on the left, the displayed
/// scenario on the right, and what the view shows of both between them.
class CompareStrip final : public QWidget {
    Q_OBJECT
public:
    explicit CompareStrip(ProjectSession& session, QWidget* parent = nullptr);  ///< it must outlive this

    void setOther(const std::string& scenario);
    void setNote(const QString& note);

Q_SIGNALS:
    void otherChosen(const std::string& scenario);
    void closed();

private:
    void fill();

    ProjectSession& session_;
    QComboBox* other_;
    QLabel* note_;
    QLabel* displayed_;
};

/// Every scenario but the displayed one, the existing city among them.
std::vector<std::string> listOthers(const ProjectSession& session);

/// Drags the divider between the two scenarios of a swipe.
class DividerHandle final : public QObject, public DragTarget {
    Q_OBJECT
public:
    /// Both must outlive this object.
    DividerHandle(CityView& view, ViewNavigator& navigator, QObject* parent = nullptr);
    ~DividerHandle() override;

    void setActive(bool active);
    bool grab(QPointF pixel) override;
    void dragTo(QPointF pixel) override;
    void drop() override {}

private:
    [[nodiscard]] bool isAt(QPointF pixel) const;
    void showCursor(QPointF pixel);
    void restoreCursor();

    CityView& view_;
    ViewNavigator& navigator_;
    bool active_ = false;
    std::optional<QCursor> before_;  ///< the cursor while the one of the divider is shown
};

struct ComparedSides;
class TimeDisplay;

/// Shows the displayed scenario and another one with one camera and at one time: side by side, divided by a
/// line that is dragged, or in turn.
class CompareActions final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    CompareActions(Workbench& workbench, ViewPanel& panel, TimeDisplay& time);
    ~CompareActions() override;

    [[nodiscard]] QList<QAction*> actions() const { return {beside_, swipe_, flicker_}; }
    [[nodiscard]] OtherScenario& other() { return other_; }

    /// Which comparison the view shows, to be saved: "compareBeside Existing"; empty: none.
    [[nodiscard]] std::string choice() const;
    void restore(const std::string& choice);  ///< does nothing where it is not valid

private:
    void begin(QAction* way, bool on);
    void end();
    void follow();
    void layOut();
    void stepBack(double widthBefore);
    void stepForward();
    void showSides();
    /// What each side shows in place of the displayed answer: of a comparison both scenarios, else the
    /// answers to the same question. None: the question is not about cells of the ground.
    [[nodiscard]] std::optional<ComparedSides> findSides();
    [[nodiscard]] QString nameSides() const;
    /// What the two sides show.
    [[nodiscard]] QString describe() const;

    Workbench& workbench_;
    ViewPanel& panel_;
    TimeDisplay& time_;
    OtherScenario other_;
    DividerHandle divider_;
    CompareStrip* strip_;
    QAction* beside_;
    QAction* swipe_;
    QAction* flicker_;
    struct Step {
        CameraPose before, after;
    };
    std::optional<Step> step_;  ///< that the camera took back for two sides
};

}  // namespace noonmark
