#include "app/gui/docks/sheets/sheet_form.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPixmap>
#include <QPushButton>
#include <QRegularExpressionValidator>
#include <QSettings>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/field_rows.h"
#include "app/report/maps/sheet_text.h"
#include "scenarios/project/title_fields.h"

namespace noonmark {

namespace {

const QString paperKey = QStringLiteral("sheets/paper"), landscapeKey = QStringLiteral("sheets/landscape");

}  // namespace

PageSetup readPageSetup(const QSettings& settings) {
    const auto saved = parsePaper(settings.value(paperKey).toString().toStdString());
    const bool isMetric = QLocale::system().measurementSystem() == QLocale::MetricSystem;
    return {saved.value_or(isMetric ? Paper::a4 : Paper::letter), settings.value(landscapeKey).toBool()};
}

void savePageSetup(const PageSetup& setup, QSettings& settings) {
    settings.setValue(paperKey, QString::fromStdString(std::string(nameOf(setup.paper))));
    settings.setValue(landscapeKey, setup.landscape);
}

namespace {

constexpr std::array offeredScales{500, 1000, 1250, 2000, 2500, 5000};
constexpr int logoHeightPx = 36;

QString scaleText(double scale) { return QStringLiteral("1:%1").arg(scale, 0, 'g', 10); }

QString nameIn(std::string_view name) { return QString::fromUtf8(name.data(), qsizetype(name.size())); }

}  // namespace

SheetForm::SheetForm(QWidget* parent)
    : QWidget(parent),
      title_(new FieldRows(titleFields().rows(), this)),
      book_(new FieldRows(bookFields().rows(), this)),
      extent_(new FieldRows(extentFields().rows(), this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    for (auto [title, make] :
         {std::pair{tr("Page"), &SheetForm::makePaper},
          std::pair{tr("Title block (saved in the project)"), &SheetForm::makeTitleBlock}}) {
        auto* group = new QGroupBox(title);
        auto* form = new QFormLayout(group);
        form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
        (this->*make)(*form);
        column->addWidget(group);
    }
    column->addStretch();
}

void SheetForm::offerExtent(bool offered) {
    for (const Field& field : extentFields().rows())
        page_->setRowVisible(extent_->widget(field.flag), offered);
}

void SheetForm::makePaper(QFormLayout& form) {
    page_ = &form;
    paper_ = addList(form, tr("Paper"), "sheetPaper", {});
    for (const Paper paper : papers) paper_->addItem(nameIn(nameOf(paper)), int(paper));
    orientation_ = addList(form, tr("Orientation"), "sheetOrientation", {});
    orientation_->addItem(tr("Portrait"), false);
    orientation_->addItem(tr("Landscape"), true);
    scale_ =
        addList(form, tr("Scale of diagrams"), "sheetScale",
                tr("A scale from 1:%1 to 1:%2 may be typed. Where a place or its shadows are larger than "
                   "the paper at that scale, the diagram shows the part around the place.")
                    .arg(BookSettings::minScale)
                    .arg(BookSettings::maxScale));
    scale_->setEditable(true);
    scale_->setInsertPolicy(QComboBox::NoInsert);
    scale_->addItem(tr("fits the page"));
    for (const int scale : offeredScales) scale_->addItem(scaleText(scale));
    connect(scale_->lineEdit(), &QLineEdit::editingFinished, this, &SheetForm::edited);
    units_ = addList(form, tr("Units"), "sheetUnits", tr("Of areas, lengths and heights"));
    for (const KeyedLabel& choice : std::ranges::find(sheetFields().rows(), "--units", &Field::flag)->choices)
        units_->addItem(translated(choice.label), int(*parseUnitSystem(choice.key)));
    for (FieldRows* rows : {book_, extent_}) {
        rows->addRows(form);
        connect(rows, &FieldRows::edited, this, &SheetForm::edited);
    }
}

void SheetForm::makeTitleBlock(QFormLayout& form) {
    title_->addRows(form, {"--title-project", "--author", "--client", "--date", "--sheet-prefix"});
    for (const std::string_view flag :
         {"--title-project", "--author", "--client", "--date", "--sheet-prefix"})
        static_cast<QLineEdit*>(title_->widget(flag))->setMaxLength(200);
    connect(title_, &FieldRows::edited, this, &SheetForm::edited);
    connect(this, &SheetForm::edited, this, &SheetForm::showToday);
    form.addRow(tr("Logo"), makeLogo());
}

QWidget* SheetForm::makeLogo() {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    logoPicture_ = new QLabel;
    auto* choose = pushButton(tr("Choose..."), "chooseLogo", tr("A PNG or JPEG picture of at most 1 MiB"));
    removeLogo_ = pushButton(tr("Remove"), "removeLogo", tr("Sheets without a logo"));
    line->addWidget(logoPicture_, 1);
    line->addWidget(choose);
    line->addWidget(removeLogo_);
    connect(choose, &QPushButton::clicked, this, &SheetForm::askForLogo);
    connect(removeLogo_, &QPushButton::clicked, this, [this] {
        logo_.clear();
        showLogo();
        Q_EMIT edited();
    });
    return row;
}

QComboBox* SheetForm::addList(QFormLayout& form, const QString& label, const char* name, const QString& tip) {
    auto* list = new QComboBox;
    list->setObjectName(QString::fromLatin1(name));
    list->setToolTip(tip);
    connect(list, &QComboBox::activated, this, &SheetForm::edited);
    form.addRow(label, list);
    return list;
}

void SheetForm::show(const BookSettings& settings) {
    const QSignalBlocker quiet(this);
    paper_->setCurrentIndex(paper_->findData(int(settings.setup.paper)));
    orientation_->setCurrentIndex(settings.setup.landscape ? 1 : 0);
    scale_->setCurrentText(settings.scale ? scaleText(*settings.scale) : scale_->itemText(0));
    units_->setCurrentIndex(units_->findData(int(settings.units)));
    title_->show(titleFields().of(settings.titleBlock));
    book_->show(bookFields().of(settings));
    extent_->show(extentFields().of(settings));
    logo_ = settings.titleBlock.logo;
    showLogo();
    showToday();
}

// Without a date the sheets have today's, in their language.
void SheetForm::showToday() {
    const SheetScope scope(statedLanguage(settings().language));
    static_cast<QLineEdit*>(title_->widget("--date"))->setPlaceholderText(describeToday());
}

BookSettings SheetForm::settings() const {
    BookSettings settings;
    settings.setup = {Paper(paper_->currentData().toInt()), orientation_->currentData().toBool()};
    const QString typed = scale_->currentText().section(QLatin1Char(':'), -1).trimmed();
    bool isNumber = false;
    const double scale = typed.toDouble(&isNumber);
    if (isNumber) settings.scale = std::clamp(scale, BookSettings::minScale, BookSettings::maxScale);
    settings.units = UnitSystem(units_->currentData().toInt());
    title_->take(titleFields().of(settings.titleBlock));
    book_->take(bookFields().of(settings));
    extent_->take(extentFields().of(settings));
    settings.titleBlock.logo = logo_;
    return settings;
}

void SheetForm::askForLogo() {
    const QString file = ::noonmark::askForLogo(this);
    if (file.isEmpty()) return;
    if (const auto taken = takeLogo(file); !taken) Q_EMIT failed(taken.error());
}

Result<void> SheetForm::takeLogo(const QString& file) {
    auto logo = readLogo(file.toStdString());
    if (!logo) return tl::make_unexpected(logo.error());
    TitleBlock block;
    block.logo = *logo;
    if (auto sound = validate(block); !sound) return sound;
    logo_ = *std::move(logo);
    showLogo();
    Q_EMIT edited();
    return {};
}

void SheetForm::showLogo() {
    QPixmap picture;
    picture.loadFromData(reinterpret_cast<const uchar*>(logo_.data()), uint(logo_.size()));
    logoPicture_->setPixmap(
        picture.isNull() ? picture : picture.scaledToHeight(logoHeightPx, Qt::SmoothTransformation));
    if (logo_.empty()) logoPicture_->setText(tr("none"));
    removeLogo_->setEnabled(!logo_.empty());
}

}  // namespace noonmark
