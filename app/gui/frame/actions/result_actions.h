#pragma once

#include <QImage>
#include <QObject>
#include <QPointer>
#include <functional>

#include "app/gui/docks/export/export_dialog.h"

class QAction;
class QWidget;

namespace noonmark {

class ModeSwitch;
class ProjectDock;
class ResultDisplay;
class ViewPanel;
class Workbench;

/// Takes results out of the window: the picture of the view, exported files, results saved in the project.
/// The last folder and the choices of an export are remembered until the window closes.
class ResultActions final : public QObject {
    Q_OBJECT
public:
    /// Dialogs belong to `window`. All must outlive this object.
    ResultActions(Workbench& workbench, const ModeSwitch& mode, const ResultDisplay& display,
                  ViewPanel& panel, ProjectDock& tree, QWidget& window);

    [[nodiscard]] QList<QAction*> fileActions() const { return {savePicture_, export_}; }
    [[nodiscard]] QAction* saveResult() const { return saveResult_; }
    [[nodiscard]] QAction* exportAction() const { return export_; }

    void savePicture(const QString& file);  ///< format by the file extension, PNG by default
    void copyPicture();                     ///< to the clipboard
    /// Opens the dialog of export. Without a city, the message bar says why.
    void askForExport();
    void askForContributions();  ///< the same, of what buildings take from a place where that is shown
    void usePaper(const PageSetup& setup) {
        last_.book.setup = setup;
    }  ///< of sheets, until another is chosen

Q_SIGNALS:
    void setupChosen(const noonmark::PageSetup& setup);
    void saveRequested();  ///< of the project, which has no file

private:
    void takePicture(std::function<void(const QImage&)> done);
    [[nodiscard]] std::pair<QString, QString> pictureTitle() const;
    void makeExportDialog();
    void exportTo(const ExportChoice& choice, const QString& folder);
    void exportView(const ExportChoice& choice, const QString& folder);
    void saveInProject();
    void nameExport();
    [[nodiscard]] QString shownText() const;
    [[nodiscard]] std::vector<ExportDialog::Subject> exportSubjects() const;
    void offerSubjects();
    [[nodiscard]] ExportChoice drawn(ExportChoice choice) const;

    Workbench& workbench_;
    const ModeSwitch& mode_;
    const ResultDisplay& display_;
    ViewPanel& panel_;
    QWidget& window_;
    QAction* savePicture_;
    QAction* export_;
    QAction* saveResult_;
    ExportChoice last_;
    QString lastFolder_;
    QPointer<ExportDialog> dialog_;
};

}  // namespace noonmark
