#include "app/gui/docks/export/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpressionValidator>
#include <QScreen>
#include <QScrollArea>
#include <QSet>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QUrl>
#include <tuple>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/docks/sheets/book_view.h"
#include "app/gui/docks/sheets/sheet_form.h"
#include "app/gui/session/project/project_session.h"
#include "app/report/files/saved_files.h"

namespace noonmark {

namespace {

struct OfferedWidth {
    const char* name;
    int pixels;
};
constexpr int waitMs = 400;  // after an edit, before the sheets are laid out again
constexpr int formWidth = 380, previewWidth = 320;
constexpr QSize sizeWithSheets{1120, 720}, aroundDialog{16, 48};  // of a window manager, about

constexpr OfferedWidth offeredWidths[] = {
    {QT_TRANSLATE_NOOP("noonmark::ExportDialog", "Screen"), pictureWidth},
    {QT_TRANSLATE_NOOP("noonmark::ExportDialog", "Large screen"), 3840},
    {QT_TRANSLATE_NOOP("noonmark::ExportDialog", "A4 in print"), 2480},
    {QT_TRANSLATE_NOOP("noonmark::ExportDialog", "A3 in print"), 4961},
    {QT_TRANSLATE_NOOP("noonmark::ExportDialog", "A1 in print"), 9933},
    {QT_TRANSLATE_NOOP("noonmark::ExportDialog", "Other"), 0}};

QCheckBox* makeCheck(const QString& text, const char* name, const QString& tip, bool on) {
    auto* box = new QCheckBox(text);
    box->setObjectName(QString::fromLatin1(name));
    box->setToolTip(tip);
    box->setChecked(on);
    return box;
}

// "Mill Lane.pdf" of "Mill Lane"; empty of no name.
QString pdfName(const QString& typed) {
    const QString ending = QStringLiteral(".pdf"), name = typed.trimmed();
    return name.isEmpty() || name.endsWith(ending, Qt::CaseInsensitive) ? name : name + ending;
}

// Whether the file holds what answers are about, as it is now: only then do exports name it as their source.
bool isSavedAsItIs(const ProjectSession& session) {
    if (!session.file()) return false;
    const auto content = [](const Project& project) {
        return std::tie(project.city, project.reading, project.scenarios, project.weights);
    };
    return content(session.project()) == content(session.file()->project());
}

}  // namespace

ExportDialog::ExportDialog(const ExportChoice& first, const QString& folder, Source source,
                           ProjectSession& session, QWidget* parent)
    : QDialog(parent),
      first_(first),
      shown_(first.book),
      source_(std::move(source)),
      session_(session),
      subject_(new QComboBox),
      form_(new SheetForm),
      pages_(new BookView),
      folder_(new QLineEdit(folder)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Export"));
    auto* body = new QHBoxLayout;
    body->addLayout(makeFields());
    pages_->setMinimumWidth(previewWidth);
    body->addWidget(pages_, 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(body, 1);
    column->addLayout(makeFoot());
    // Room for sheets from the start: nothing moves when they are ticked.
    resize(sizeWithSheets.boundedTo(screen()->availableSize() - aroundDialog));
    // Enter in a field ends its editing, and presses no button.
    for (QPushButton* button : findChildren<QPushButton*>()) button->setAutoDefault(false);
    soon_.setSingleShot(true);
    soon_.setInterval(0);  // the first time
    connect(&soon_, &QTimer::timeout, this, &ExportDialog::layOut);
    connect(subject_, &QComboBox::currentIndexChanged, this, &ExportDialog::update);
    connect(folder_, &QLineEdit::textChanged, this, &ExportDialog::update);
    connect(form_, &SheetForm::edited, this, &ExportDialog::takeForm);
    connect(form_, &SheetForm::failed, this, &ExportDialog::showError);
    connect(&session_, &ProjectSession::changed, this, &ExportDialog::showProject);
    connect(&session_, &ProjectSession::changed, this, &ExportDialog::update);
    connect(&session_, &ProjectSession::unsavedChanged, this, &ExportDialog::update);
    for (QCheckBox* box : {cells_, sheets_}) connect(box, &QCheckBox::toggled, this, &ExportDialog::update);
    showProject();
}

QLayout* ExportDialog::makeFields() {
    subject_->setObjectName(QStringLiteral("exportSubject"));
    auto* form = fields_ = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("What"), subject_);
    makePicture(*form);
    cells_ = makeCheck(tr("Table of all cells"), "exportCells",
                       tr("A line of text for each cell: large for a large region"), first_.cells);
    form->addRow(QString(), cells_);
    makeSheets(*form);
    makeFolder(*form, folder_->text());
    auto* sheets = new QScrollArea;
    sheets->setWidget(form_);
    sheets->setWidgetResizable(true);
    sheets->setFrameShape(QFrame::NoFrame);
    sheets->setMinimumWidth(formWidth);
    auto* column = new QVBoxLayout;
    column->addLayout(form);
    column->addWidget(sheets, 1);
    return column;
}

void ExportDialog::makeSheets(QFormLayout& form) {
    sheets_ = makeCheck(tr("Sheets with a title block"), "exportSheets",
                        tr("A PDF with maps, figures, charts and method on several pages"), first_.sheets);
    sheetsName_ = new QLineEdit(QString::fromStdString(first_.sheetsName));
    sheetsName_->setObjectName(QStringLiteral("exportSheetsName"));
    sheetsName_->setToolTip(tr("The name of the PDF with the sheets"));
    sheetsName_->setPlaceholderText(QString::fromLatin1(sheetsFileName));
    sheetsName_->setMaxLength(120);
    sheetsName_->setValidator(new QRegularExpressionValidator(
        QRegularExpression(QStringLiteral("[^/\\\\:*?\"<>|]*")), sheetsName_));
    connect(sheetsName_, &QLineEdit::textChanged, this, &ExportDialog::update);
    form.addRow(QString(), sheets_);
    form.addRow(tr("Name of the sheets"), sheetsName_);
}

void ExportDialog::makePicture(QFormLayout& form) {
    width_ = new QComboBox;
    width_->setObjectName(QStringLiteral("exportWidth"));
    for (const OfferedWidth& width : offeredWidths) width_->addItem(tr(width.name));
    pixels_ = new QSpinBox;
    pixels_->setObjectName(QStringLiteral("exportPixels"));
    pixels_->setRange(minPictureWidth, maxPictureWidth);
    pixels_->setSuffix(tr(" pixels wide"));
    pixels_->setValue(first_.pictureWidth);
    connect(width_, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (offeredWidths[index].pixels > 0) pixels_->setValue(offeredWidths[index].pixels);
    });
    height_ = new QSpinBox;
    height_->setObjectName(QStringLiteral("exportHeight"));
    height_->setRange(ExportChoice::minHeight, ExportChoice::maxSide);
    height_->setSuffix(tr(" pixels high"));
    height_->setValue(first_.pictureHeight);
    framed_ = makeCheck(tr("Title, legend and scale bar"), "exportFramed",
                        tr("Around the view, within the size of the picture"), first_.framed);
    form.addRow(tr("Picture"), widgetRow({width_, pixels_, height_}));
    form.addRow(QString(), framed_);
}

void ExportDialog::makeFolder(QFormLayout& form, const QString& folder) {
    files_ = new QLabel;
    files_->setObjectName(QStringLiteral("exportFiles"));
    files_->setWordWrap(true);
    folder_->setText(folder);
    folder_->setObjectName(QStringLiteral("exportFolder"));
    folder_->setPlaceholderText(tr("a folder; it is created if missing"));
    auto* browse = pushButton(tr("Browse..."), "exportBrowse", tr("Choose a folder"));
    connect(browse, &QPushButton::clicked, this, [this] {
        const QString asked = askForFolder(this, tr("Export to folder"));
        if (!asked.isEmpty()) folder_->setText(asked);
    });
    form.addRow(tr("Files"), files_);
    form.addRow(tr("Folder"), widgetRow({folder_, browse}));
}

QLayout* ExportDialog::makeFoot() {
    message_ = new QLabel;
    message_->setObjectName(QStringLiteral("exportMessage"));
    message_->setWordWrap(true);
    progress_ = new ProgressStrip(QBoxLayout::LeftToRight);
    progress_->follow(layoutJob_);
    withProject_ =
        makeCheck(tr("With the project"), "exportWithProject",
                  tr("Puts a copy of the project's file into the folder, so that the result can be "
                     "verified from there"),
                  first_.withProject);
    unsaved_ = new QLabel;
    unsaved_->setObjectName(QStringLiteral("exportUnsaved"));
    unsaved_->setWordWrap(true);
    saveFirst_ = pushButton({}, "exportSaveFirst",
                            tr("A result can be verified only with the project that it comes from"));
    connect(saveFirst_, &QPushButton::clicked, this, &ExportDialog::saveRequested);
    write_ = pushButton(tr("Export"), "exportWrite", {});
    openFolder_ = pushButton(tr("Open folder"), "exportOpenFolder", tr("Shows the written files"));
    openFolder_->setEnabled(false);
    auto* close = pushButton(tr("Close"), "exportClose", {});
    connect(write_, &QPushButton::clicked, this, &ExportDialog::write);
    connect(openFolder_, &QPushButton::clicked, this,
            [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(writtenTo_)); });
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    auto* row = new QHBoxLayout;
    row->addWidget(progress_, 1);
    row->addStretch();
    for (QWidget* field :
         std::initializer_list<QWidget*>{withProject_, saveFirst_, write_, openFolder_, close})
        row->addWidget(field);
    auto* foot = new QVBoxLayout;
    foot->addWidget(unsaved_);
    foot->addWidget(message_);  // above the buttons: a path beside them would be broken letter by letter
    foot->addLayout(row);
    return foot;
}

void ExportDialog::offer(const std::vector<Subject>& subjects) {
    const QVariant before = subject_->currentData();
    {
        const QSignalBlocker quiet(subject_);
        subject_->clear();
        for (const Subject& subject : subjects) subject_->addItem(subject.name, int(subject.key));
        subject_->setCurrentIndex(std::max(0, subject_->findData(before)));
    }
    update();
}

void ExportDialog::choose(ExportChoice::Subject subject) {
    if (const int at = subject_->findData(int(subject)); at >= 0) subject_->setCurrentIndex(at);
}

void ExportDialog::followWriting(JobSlot& writing) {
    progress_->follow(writing);
    const auto setWriting = [this](bool on) {
        writing_ = on;
        update();
    };
    connect(&writing, &JobSlot::started, this, [setWriting] { setWriting(true); });
    connect(&writing, &JobSlot::ended, this, [setWriting] { setWriting(false); });
}

void ExportDialog::showWritten(const QString& folder) {
    message_->setText(tr("Written to %1").arg(folder));
    writtenTo_ = folder;
    openFolder_->setEnabled(true);
}

void ExportDialog::showError(const Error& error) {
    message_->setText(isCancelled(error) ? tr("Cancelled. Any change lays the sheets out again.")
                                         : describeError(error));
}

ExportChoice ExportDialog::choice() const {
    ExportChoice choice = first_;
    choice.subject = ExportChoice::Subject(subject_->currentData().toInt());
    choice.pictureWidth = pixels_->value();
    choice.pictureHeight = height_->value();
    choice.framed = framed_->isChecked();
    choice.cells = cells_->isChecked();
    choice.sheets = sheets_->isChecked();
    choice.sheetsName = pdfName(sheetsName_->text()).toStdString();
    choice.book = shown_;
    choice.withProject = withProject_->isEnabled() && withProject_->isChecked();
    return choice;
}

QString ExportDialog::folder() const { return QDir::cleanPath(folder_->text().trimmed()); }

// The fields that matter for the subject: those whose files come and go with them.
void ExportDialog::update() {
    const ExportChoice now = choice();
    const QStringList names = source_.files(now);
    const auto differs = [&](bool ExportChoice::*field) {
        ExportChoice other = now;
        other.*field = !(other.*field);
        return source_.files(other) != names;
    };
    files_->setText(names.join(QStringLiteral(", ")));
    cells_->setEnabled(differs(&ExportChoice::cells));
    sheets_->setEnabled(differs(&ExportChoice::sheets));
    const bool hasPicture = names.join(QLatin1Char(' ')).contains(QStringLiteral(".png"));
    for (QWidget* field : std::initializer_list<QWidget*>{width_, pixels_}) field->setEnabled(hasPicture);
    const bool isView = now.subject == ExportChoice::Subject::view;
    pixels_->setMaximum(isView ? ExportChoice::maxSide : maxPictureWidth);
    height_->setVisible(isView);
    fields_->setRowVisible(framed_, isView);
    // What a result has always, or never, is not asked.
    for (QCheckBox* box : {cells_, sheets_}) fields_->setRowVisible(box, !isView && box->isEnabled());
    fields_->setRowVisible(sheetsName_, source_.hasSheets(now));
    form_->offerExtent(source_.isReview(now));
    const bool isSaved = session_.file().has_value();
    withProject_->setEnabled(!isView && isSaved);
    withProject_->setVisible(isView || isSaved);
    const bool canBeVerified = isView || source_.isOfFiles(now) || isSavedAsItIs(session_);
    unsaved_->setText(isSaved
                          ? tr("The project has changes that are not saved: what is exported now cannot be "
                               "verified.")
                          : tr("The project is not saved: what is exported now cannot be verified."));
    saveFirst_->setText(isSaved ? tr("Save project first") : tr("Save project first..."));
    for (QWidget* one : std::initializer_list<QWidget*>{unsaved_, saveFirst_})
        one->setVisible(!canBeVerified);
    const bool isTwice = QSet<QString>(names.begin(), names.end()).size() < names.size();
    if (isTwice) message_->setText(tr("Two of the files have one name: choose another for the sheets"));
    if (!isTwice && wasTwice_) message_->clear();
    wasTwice_ = isTwice;
    write_->setEnabled(!writing_ && !isTwice && !folder_->text().trimmed().isEmpty());
    soon_.start();
}

void ExportDialog::takeForm() {
    BookSettings chosen = form_->settings();
    chosen.legend = shown_.legend;
    if (chosen == shown_) return;
    if (!(chosen.setup == shown_.setup)) Q_EMIT setupChosen(chosen.setup);
    shown_ = chosen;
    soon_.start();
    Project next = session_.project();
    const SheetSettings sheets{chosen.titleBlock, chosen.units};
    if (next.sheets == sheets) return;
    next.sheets = sheets;
    session_.change(std::move(next), tr("Title block"));
}

void ExportDialog::showProject() {
    const SheetSettings& sheets = session_.project().sheets;
    shown_.titleBlock = sheets.titleBlock;
    shown_.units = sheets.units;
    form_->show(shown_);
    soon_.start();
}

void ExportDialog::layOut() {
    soon_.setInterval(waitMs);
    SheetsToMake wanted = source_.sheets(choice());
    if (!wanted.make) {
        laidOutFrom_.reset();
        layoutJob_.drop();
        return showSheets(nullptr);
    }
    if (laidOutFrom_ == wanted.from) return;
    laidOutFrom_ = std::move(wanted.from);
    using Sheets = std::shared_ptr<const Book>;
    layoutJob_.start<Sheets>(tr("Laying out the sheets"), wanted.make, [this](const Result<Sheets>& sheets) {
        if (sheets) return showSheets(*sheets);
        laidOutFrom_.reset();
        showError(sheets.error());
    });
}

void ExportDialog::showSheets(const std::shared_ptr<const Book>& book) {
    form_->setVisible(book != nullptr);
    pages_->show(book, whyNoSheets());
}

QString ExportDialog::whyNoSheets() const {
    const bool areOffered = fields_->isRowVisible(sheets_) && !sheets_->isChecked();
    return areOffered ? tr("No sheets are written. Tick \"%1\" to see and write them.").arg(sheets_->text())
                      : tr("What is chosen has no sheets.");
}

void ExportDialog::write() {
    message_->clear();
    Q_EMIT chosen(choice(), folder());
}

}  // namespace noonmark
