#pragma once

#include <QObject>

class QAction;
class QLabel;

namespace noonmark {

class ViewPanel;
class Workbench;

/// Colours the buildings in the view by where their heights come from, with a legend below the view, on
/// request.
class HeightColours final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive this object.
    HeightColours(Workbench& workbench, ViewPanel& panel);

    [[nodiscard]] QAction* action() const { return action_; }  ///< checkable
    [[nodiscard]] QLabel* legend() const { return legend_; }   ///< hidden while off

private:
    void refresh();

    Workbench& workbench_;
    ViewPanel& panel_;
    QAction* action_;
    QLabel* legend_;
};

}  // namespace noonmark
