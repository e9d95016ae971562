#pragma once

#include <map>
#include <string>

class QSettings;

namespace noonmark {

class ModeSwitch;
class ReviewSession;
class ViewPanel;
struct ViewState;
class Workbench;

/// The window's state that is saved in the project: camera, mode, measure, scenario, study, review.
class WindowView {
public:
    /// All must outlive this object.
    WindowView(Workbench& workbench, ViewPanel& panel, ModeSwitch& mode, ReviewSession& review,
               QSettings& settings)
        : workbench_(workbench), panel_(panel), mode_(mode), review_(review), settings_(settings) {}

    [[nodiscard]] std::map<std::string, std::string> toSave() const;
    /// Shows the project that has been opened as it was saved; a new one from the south, its region in the
    /// middle, with shadow or sun as it was last chosen. Scenario and study are in the workbench already.
    void restore();
    /// Shows another window's view of the same project.
    void restore(const ViewState& view);
    /// For new projects: shadow or sun, as it is shown now.
    void rememberShown();

private:
    Workbench& workbench_;
    ViewPanel& panel_;
    ModeSwitch& mode_;
    ReviewSession& review_;
    QSettings& settings_;
};

}  // namespace noonmark
