#include "app/gui/docks/export/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/push_button.h"

namespace noonmark {

namespace {

struct OfferedWidth {
    const char* name;
    int pixels;
};
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

QWidget* makeRow(std::initializer_list<QWidget*> fields) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    for (QWidget* field : fields) line->addWidget(field);
    return row;
}

}  // namespace

ExportDialog::ExportDialog(const std::vector<Subject>& subjects, const ExportChoice& first,
                           const QString& folder, ListFiles listFiles, QWidget* parent)
    : QDialog(parent), first_(first), listFiles_(std::move(listFiles)), subject_(new QComboBox) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Export"));
    subject_->setObjectName(QStringLiteral("exportSubject"));
    for (const Subject& subject : subjects) subject_->addItem(subject.name, int(subject.key));
    auto* form = new QFormLayout(this);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("What"), subject_);
    makeFields(*form);
    makeFolder(*form, folder);
    makeButtons(*form);
    connect(subject_, &QComboBox::currentIndexChanged, this, &ExportDialog::update);
    connect(width_, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (offeredWidths[index].pixels > 0) pixels_->setValue(offeredWidths[index].pixels);
    });
    for (QCheckBox* box : {cells_, sheets_}) connect(box, &QCheckBox::toggled, this, &ExportDialog::update);
    update();
    setMinimumWidth(460);
}

void ExportDialog::makeFields(QFormLayout& form) {
    width_ = new QComboBox;
    width_->setObjectName(QStringLiteral("exportWidth"));
    for (const OfferedWidth& width : offeredWidths) width_->addItem(tr(width.name));
    pixels_ = new QSpinBox;
    pixels_->setObjectName(QStringLiteral("exportPixels"));
    pixels_->setRange(minPictureWidth, maxPictureWidth);
    pixels_->setSuffix(tr(" pixels wide"));
    pixels_->setValue(first_.pictureWidth);
    form.addRow(tr("Picture"), makeRow({width_, pixels_}));
    cells_ = makeCheck(tr("Table of all cells"), "exportCells",
                       tr("A line of text for each cell: large for a large region"), first_.cells);
    sheets_ = makeCheck(tr("Sheets with a title block"), "exportSheets",
                        tr("A PDF with maps, figures, charts and method on several pages"), first_.sheets);
    paper_ = new QComboBox;
    for (const Paper paper : papers) {
        const std::string_view name = nameOf(paper);
        paper_->addItem(QString::fromUtf8(name.data(), qsizetype(name.size())), int(paper));
    }
    paper_->setCurrentIndex(paper_->findData(int(first_.book.setup.paper)));
    landscape_ = makeCheck(tr("Landscape"), "exportLandscape", {}, first_.book.setup.landscape);
    form.addRow(QString(), cells_);
    form.addRow(QString(), sheets_);
    form.addRow(tr("Paper"), makeRow({paper_, landscape_}));
}

void ExportDialog::makeFolder(QFormLayout& form, const QString& folder) {
    files_ = new QLabel;
    files_->setObjectName(QStringLiteral("exportFiles"));
    files_->setWordWrap(true);
    folder_ = new QLineEdit(folder);
    folder_->setObjectName(QStringLiteral("exportFolder"));
    folder_->setPlaceholderText(tr("a folder; it is created if missing"));
    auto* browse = pushButton(tr("Browse..."), "exportBrowse", tr("Choose a folder"));
    browse->setAutoDefault(false);
    connect(browse, &QPushButton::clicked, this, [this] {
        const QString asked = askForFolder(this, tr("Export to folder"));
        if (!asked.isEmpty()) folder_->setText(asked);
    });
    connect(folder_, &QLineEdit::textChanged, this, &ExportDialog::update);
    form.addRow(tr("Files"), files_);
    form.addRow(tr("Folder"), makeRow({folder_, browse}));
}

void ExportDialog::makeButtons(QFormLayout& form) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    write_ = pushButton(tr("Export"), "exportWrite", {});
    buttons->addButton(write_, QDialogButtonBox::AcceptRole);
    form.addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::take);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

ExportChoice ExportDialog::choice() const {
    ExportChoice choice = first_;
    choice.subject = ExportChoice::Subject(subject_->currentData().toInt());
    choice.pictureWidth = pixels_->value();
    choice.cells = cells_->isChecked();
    choice.sheets = sheets_->isChecked();
    choice.book.setup = {Paper(paper_->currentData().toInt()), landscape_->isChecked()};
    return choice;
}

QString ExportDialog::folder() const { return QDir::cleanPath(folder_->text().trimmed()); }

// The fields that matter for the subject: those whose files come and go with them.
void ExportDialog::update() {
    const ExportChoice now = choice();
    const bool isReview = now.subject == ExportChoice::Subject::review;
    const QStringList names = listFiles_(now);
    const auto differs = [&](bool ExportChoice::*field) {
        ExportChoice other = now;
        other.*field = !(other.*field);
        return listFiles_(other) != names;
    };
    files_->setText(isReview ? tr("The sheets are shown first") : names.join(QStringLiteral(", ")));
    cells_->setEnabled(differs(&ExportChoice::cells));
    sheets_->setEnabled(differs(&ExportChoice::sheets));
    const bool hasBook =
        now.subject == ExportChoice::Subject::scenarios || (sheets_->isEnabled() && now.sheets);
    for (QWidget* field : std::initializer_list<QWidget*>{paper_, landscape_}) field->setEnabled(hasBook);
    const bool hasPicture = names.join(QLatin1Char(' ')).contains(QStringLiteral(".png"));
    for (QWidget* field : std::initializer_list<QWidget*>{width_, pixels_}) field->setEnabled(hasPicture);
    folder_->setEnabled(!isReview);
    write_->setText(isReview ? tr("Show the sheets") : tr("Export"));
    write_->setEnabled(isReview || !folder_->text().trimmed().isEmpty());
}

void ExportDialog::take() {
    Q_EMIT chosen(choice(), folder());
    accept();
}

}  // namespace noonmark
