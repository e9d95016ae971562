#include "app/gui/docks/sheets/sheets_dialog.h"

#include <QCheckBox>
#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QUrl>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/error_words.h"
#include "app/gui/base/widgets/progress_strip.h"
#include "app/gui/base/widgets/push_button.h"
#include "app/gui/docks/sheets/book_view.h"
#include "app/gui/docks/sheets/page_settings.h"
#include "app/gui/docks/sheets/sheet_form.h"
#include "app/gui/session/project/project_session.h"
#include "app/report/files/review_files.h"

namespace noonmark {

namespace {

constexpr int waitMs = 400;  // after an edit, before the sheets are laid out again
constexpr int formWidth = 330;

}  // namespace

SheetsDialog::SheetsDialog(std::shared_ptr<const ReviewAnswer> answer, ReviewSource source,
                           ProjectSession& session, const BookSettings& begin, QWidget* parent)
    : QDialog(parent),
      answer_(std::move(answer)),
      source_(std::move(source)),
      session_(session),
      form_(new SheetForm(SheetForm::Of::review)),
      pages_(new BookView),
      progress_(new ProgressStrip(QBoxLayout::LeftToRight)),
      message_(new QLabel),
      withProject_(new QCheckBox(tr("With the project"))),
      write_(
          pushButton(tr("Write files..."), "writeSheets",
                     tr("Writes the sheets (PDF), the table (CSV), the data (JSON), and the shadows for CAD "
                        "and GIS (DXF, GeoPackage) to a folder"))),
      openFolder_(pushButton(tr("Open folder"), "openFolder", tr("Shows the written files"))) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Sheets of the review"));
    arrange();
    soon_.setSingleShot(true);
    soon_.setInterval(waitMs);
    progress_->follow(working_);
    connect(&soon_, &QTimer::timeout, this, &SheetsDialog::layOut);
    connect(form_, &SheetForm::edited, this, &SheetsDialog::takeForm);
    connect(form_, &SheetForm::failed, this, &SheetsDialog::tell);
    connect(write_, &QPushButton::clicked, this, &SheetsDialog::askForFolder);
    connect(&session_, &ProjectSession::changed, this, &SheetsDialog::showProject);
    shown_ = begin;
    showProject();
}

void SheetsDialog::arrange() {
    auto* fields = new QScrollArea;
    fields->setWidget(form_);
    fields->setWidgetResizable(true);
    fields->setFrameShape(QFrame::NoFrame);
    fields->setFixedWidth(formWidth);
    auto* close = pushButton(tr("Close"), "closeSheets", {});
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    message_->setObjectName(QStringLiteral("sheetsMessage"));
    message_->setWordWrap(true);
    auto* foot = new QHBoxLayout;
    foot->addWidget(message_, 1);
    foot->addWidget(progress_, 1);
    withProject_->setObjectName(QStringLiteral("withProject"));
    withProject_->setToolTip(
        tr("Puts a copy of the project's file into the folder, so that the report can be verified "
           "from there"));
    withProject_->setEnabled(source_.file.has_value());
    foot->addWidget(withProject_);
    foot->addWidget(write_);
    foot->addWidget(openFolder_);
    foot->addWidget(close);
    openFolder_->setEnabled(false);
    connect(openFolder_, &QPushButton::clicked, this,
            [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(writtenTo_)); });
    auto* body = new QHBoxLayout;
    body->addWidget(fields);
    body->addWidget(pages_, 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(body, 1);
    column->addLayout(foot);
    // Enter in a field ends its editing, and presses no button.
    for (QPushButton* button : findChildren<QPushButton*>()) button->setAutoDefault(false);
    resize(1120, 780);
}

// The date is stated when the sheets are laid out.
BookSettings SheetsDialog::settings() const {
    BookSettings settings = shown_;
    if (settings.titleBlock.date.empty()) settings.titleBlock.date = describeToday().toStdString();
    return settings;
}

void SheetsDialog::takeForm() {
    BookSettings chosen = form_->settings();
    chosen.legend = shown_.legend;
    if (chosen == shown_) return;
    if (!(chosen.setup == shown_.setup)) Q_EMIT setupChosen(chosen.setup);
    shown_ = chosen;
    saveTitleBlock(chosen, session_);
    soon_.start();
}

void SheetsDialog::showProject() {
    const SheetSettings& sheets = session_.project().sheets;
    shown_.titleBlock = sheets.titleBlock;
    shown_.units = sheets.units;
    form_->show(shown_);
    if (!sheets_ || settings() != sheets_->settings) soon_.start();
}

void SheetsDialog::layOut() { layOutFor({}); }

void SheetsDialog::layOutFor(const QString& folder) {
    message_->clear();
    source_.project.sheets = session_.project().sheets;
    working_.start<std::shared_ptr<const ReviewSheets>>(
        tr("Laying out the sheets"),
        [answer = answer_, source = source_, study = sheets_ ? sheets_->study : nullptr,
         settings = settings()](Progress& progress, const std::stop_token& stop) {
            return layOutReview(answer->question, source, study, settings, progress, stop);
        },
        [this, folder](Result<std::shared_ptr<const ReviewSheets>> sheets) {
            if (!sheets) return tell(sheets.error());
            take(*std::move(sheets), folder);
        });
}

void SheetsDialog::take(std::shared_ptr<const ReviewSheets> sheets, const QString& folder) {
    sheets_ = std::move(sheets);
    pages_->show({sheets_, &sheets_->book});
    if (!folder.isEmpty()) writeFiles(folder);
}

void SheetsDialog::write(const QString& folder) {
    soon_.stop();
    if (sheets_ && settings() == sheets_->settings) return writeFiles(folder);
    layOutFor(folder);
}

void SheetsDialog::writeFiles(const QString& folder) {
    using Paths = std::vector<std::filesystem::path>;
    working_.start<Paths>(
        tr("Writing the files"),
        [answer = answer_, source = source_, sheets = sheets_, folder,
         copies = withProject_->isEnabled() && withProject_->isChecked()](
            Progress& progress, const std::stop_token& stop) -> Result<Paths> {
            const std::filesystem::path where = folder.toStdString();
            if (copies)
                if (const auto may = checkCopy(*source.file, where); !may)
                    return tl::make_unexpected(may.error());
            auto paths = writeReview(answer->question, source, *sheets, where, false, progress, stop);
            if (!paths || !copies) return paths;
            if (const auto copied = copyProject(*source.file, where); !copied)
                return tl::make_unexpected(copied.error());
            return paths;
        },
        [this, folder](Result<Paths> paths) {
            if (!paths) return tell(paths.error());
            message_->setText(tr("Written to %1").arg(folder));
            writtenTo_ = folder;
            openFolder_->setEnabled(true);
            Q_EMIT written(folder);
        });
}

void SheetsDialog::askForFolder() {
    const QString folder = ::noonmark::askForFolder(this, tr("Write the files of the review to folder"));
    if (folder.isEmpty()) return;
    if (mayReplace(this, folder, filesInTheWay(folder, reviewFileNames()))) write(folder);
}

void SheetsDialog::tell(const Error& error) {
    if (isCancelled(error)) return message_->setText(tr("Cancelled. Any change lays the sheets out again."));
    message_->setText(describeError(error));
    Q_EMIT failed(error);
}

}  // namespace noonmark
