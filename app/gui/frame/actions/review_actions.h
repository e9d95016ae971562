#pragma once

#include <QObject>
#include <QPointer>

class QAction;
class QSettings;
class QWidget;

namespace noonmark {

class EditPreview;
class PlaceActions;
class ReviewDock;
class ReviewSession;
class GlazingSession;
class SheetsDialog;
class ViewPanel;
class Workbench;

/// Shows the review dock and the sheets of a review, and lets the verdicts follow the building that is being
/// shaped.
class ReviewActions final : public QObject {
    Q_OBJECT
public:
    /// Dialogs belong to `window`. All must outlive this object.
    ReviewActions(Workbench& workbench, ReviewSession& review, GlazingSession& windows, ReviewDock& dock,
                  EditPreview& preview, PlaceActions& places, ViewPanel& panel, QSettings& settings,
                  QWidget& window);

    [[nodiscard]] QList<QAction*> actions() const { return {show_, export_}; }
    [[nodiscard]] QAction* sheetsAction() const { return export_; }

Q_SIGNALS:
    void dockWanted();

private:
    void tellVerdicts(EditPreview& preview) const;
    void exportReview();
    void exportGlazing();
    void showSheets();
    void closeSheets();

    Workbench& workbench_;
    ReviewSession& review_;
    GlazingSession& windows_;
    ViewPanel& panel_;
    QSettings& settings_;  // the paper last chosen
    QWidget& window_;
    QPointer<SheetsDialog> sheets_;
    QAction* show_;
    QAction* export_;
};

}  // namespace noonmark
