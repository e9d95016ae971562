#pragma once

// Two scenarios in one view. CompareActions has the entries of the menu and decides what is shown;
// OtherScenario prepares the other scenario's city; CompareStrip names both above the view; DividerHandle
// drags the line between them.

#include <QObject>

#include "app/gui/view/compare/divider_handle.h"
#include "app/gui/view/compare/other_scenario.h"

class QAction;

namespace noonmark {

class CompareStrip;
struct Study;
class TimeDisplay;
class Workbench;
class ViewPanel;

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

private:
    void begin(QAction* way, bool on);
    void end();
    void follow();
    void layOut();
    void showPicture();
    /// Of the other scenario with the settings of the study that is shown; null: not measured, or none shown.
    [[nodiscard]] std::shared_ptr<const Study> findStudy() const;
    [[nodiscard]] QString nameSides() const;
    /// What the two sides show. `measured`: the other scenario has the study that is shown.
    [[nodiscard]] QString describe(bool measured) const;

    Workbench& workbench_;
    ViewPanel& panel_;
    TimeDisplay& time_;
    OtherScenario other_;
    DividerHandle divider_;
    CompareStrip* strip_;
    QAction* beside_;
    QAction* swipe_;
    QAction* flicker_;
};

}  // namespace noonmark
