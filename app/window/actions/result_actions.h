#pragma once

#include <QObject>

class QAction;
class QWidget;

namespace noonmark {

class ModeSwitch;
class ProjectDock;
class ResultDisplay;
class ViewPanel;
class Workbench;

/// Takes results out of the window: the picture of the view, exported files, results saved in the project.
class ResultActions final : public QObject {
    Q_OBJECT
public:
    /// Dialogs belong to `window`. All must outlive this object.
    ResultActions(Workbench& workbench, const ModeSwitch& mode, const ResultDisplay& display,
                  ViewPanel& panel, ProjectDock& tree, QWidget& window);

    [[nodiscard]] QList<QAction*> fileActions() const { return {savePicture_, export_}; }
    [[nodiscard]] QAction* saveResult() const { return saveResult_; }

    void savePicture(const QString& file);  ///< format by the file extension, PNG by default

private:
    void exportShown();
    void saveInProject();
    void nameExport();
    [[nodiscard]] QString exportText() const;

    Workbench& workbench_;
    const ModeSwitch& mode_;
    const ResultDisplay& display_;
    ViewPanel& panel_;
    QWidget& window_;
    QAction* savePicture_;
    QAction* export_;
    QAction* saveResult_;
};

}  // namespace noonmark
