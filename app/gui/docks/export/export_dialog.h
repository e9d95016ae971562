#pragma once

#include <QDialog>
#include <QTimer>
#include <functional>

#include "app/gui/base/jobs/job.h"
#include "app/gui/session/answers/export_choice.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace noonmark {

class BookView;
class ProgressStrip;
class ProjectSession;
class SheetForm;

/// Asks what to export, how, and to which folder; lists the files that will be written and shows the sheets
/// among them, page by page as they will be printed. Title block and units of sheets are the project's: to
/// change them is an undo step. Stays open, so that the written files can be looked at. Not modal.
class ExportDialog final : public QDialog {
    Q_OBJECT
public:
    struct Subject {
        ExportChoice::Subject key;
        QString name;  ///< "Study of Existing"
    };
    /// What the dialog asks of the window.
    struct Source {
        /// The names of the files that a choice writes.
        std::function<QStringList(const ExportChoice&)> files;
        std::function<SheetsToMake(const ExportChoice&)> sheets;  ///< that a choice writes
        std::function<bool(const ExportChoice&)> hasSheets;       ///< as a file that may be named
        /// Whether the sheets are those of a review of places, which may be many.
        std::function<bool(const ExportChoice&)> isReview;
        /// Whether the files that were read suffice to repeat it, without a saved project.
        std::function<bool(const ExportChoice&)> isOfFiles;
    };

    /// `first`: what the fields begin with. `session` must outlive the dialog.
    ExportDialog(const ExportChoice& first, const QString& folder, Source source, ProjectSession& session,
                 QWidget* parent);

    /// At least one. The chosen one stays chosen if it is among them; at first it is the first.
    void offer(const std::vector<Subject>& subjects);
    void choose(ExportChoice::Subject subject);  ///< where it is offered
    void followWriting(JobSlot& writing);        ///< of the files; it must outlive the dialog
    void showWritten(const QString& folder);
    void showError(const Error& error);

    [[nodiscard]] ExportChoice choice() const;
    [[nodiscard]] QString folder() const;
    [[nodiscard]] SheetForm& form() { return *form_; }
    [[nodiscard]] BookView& pages() { return *pages_; }
    /// The sheets are being laid out, or soon will be.
    [[nodiscard]] bool busy() const { return soon_.isActive() || layoutJob_.busy(); }

Q_SIGNALS:
    void chosen(noonmark::ExportChoice choice, QString folder);
    void setupChosen(const noonmark::PageSetup& setup);
    void saveRequested();  ///< of the project, which has no file or changes since

private:
    QLayout* makeFields();
    void makePicture(QFormLayout& form);
    void makeSheets(QFormLayout& form);
    [[nodiscard]] QString whyNoSheets() const;
    void makeFolder(QFormLayout& form, const QString& folder);
    QLayout* makeFoot();
    void update();
    void takeForm();
    void showProject();
    void layOut();
    void showSheets(const std::shared_ptr<const Book>& book);
    void write();

    ExportChoice first_;
    BookSettings shown_;  // the form's
    Source source_;
    ProjectSession& session_;
    QComboBox* subject_;
    QComboBox* width_;
    QSpinBox* pixels_;
    QSpinBox* height_;  // of the view
    QCheckBox* framed_;
    QFormLayout* fields_;
    QCheckBox* cells_;
    QCheckBox* sheets_;
    QLineEdit* sheetsName_;
    SheetForm* form_;
    BookView* pages_;
    QLabel* files_;
    QLineEdit* folder_;
    QLabel* message_;
    ProgressStrip* progress_;
    QCheckBox* withProject_;
    QLabel* unsaved_;
    QPushButton* saveFirst_;
    bool writing_ = false;
    bool wasTwice_ = false;  // two files had one name
    QPushButton* write_;
    QPushButton* openFolder_;  // the one that was written last
    QString writtenTo_;
    QTimer soon_;
    std::optional<PrintedFrom> laidOutFrom_;  // the sheets that are shown or being laid out
    JobSlot layoutJob_;
};

}  // namespace noonmark
