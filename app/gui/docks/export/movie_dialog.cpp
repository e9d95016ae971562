#include "app/gui/docks/export/movie_actions.h"

#include <QComboBox>
#include <QDateEdit>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTimeEdit>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/number_text.h"

namespace noonmark {

namespace {

constexpr QSize movieSizes[] = {{640, 360}, {1280, 720}, {1920, 1080}, {3840, 2160}};

QComboBox* makeList(const char* name, const QString& tip) {
    auto* list = new QComboBox;
    list->setObjectName(QString::fromLatin1(name));
    list->setToolTip(tip);
    return list;
}

QSpinBox* makeNumber(const char* name, int minimum, int maximum, int value, const QString& suffix) {
    auto* field = new QSpinBox;
    field->setObjectName(QString::fromLatin1(name));
    field->setRange(minimum, maximum);
    field->setValue(value);
    field->setSuffix(suffix);
    return field;
}

}  // namespace

MovieDialog::MovieDialog(const MovieChoice& first, bool comparing, int days, QWidget* parent)
    : QDialog(parent) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Export movie"));
    auto* form = new QFormLayout(this);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    makeTimes(*form, first, comparing, days);
    makePicture(*form, first);
    makeButtons(*form);
    for (QComboBox* list : {kind_, area_})
        connect(list, &QComboBox::currentIndexChanged, this, &MovieDialog::update);
    for (QDateTimeEdit* field : std::initializer_list<QDateTimeEdit*>{date_, at_})
        connect(field, &QDateTimeEdit::dateTimeChanged, this, &MovieDialog::momentChosen);
    update();
    setMinimumWidth(440);
}

void MovieDialog::makeTimes(QFormLayout& form, const MovieChoice& first, bool comparing, int days) {
    kind_ = makeList("movieKind", tr("What changes from frame to frame"));
    kind_->addItem(tr("Shadows of one day"), int(MovieChoice::Kind::day));
    kind_->addItem(tr("Shadows at one time through the year"), int(MovieChoice::Kind::year));
    if (days > 1)
        kind_->addItem(tr("Shadows at one time through the period"), int(MovieChoice::Kind::period));
    if (comparing) kind_->addItem(tr("From baseline to scenario"), int(MovieChoice::Kind::swipe));
    date_ = new QDateEdit(dateOf(first.date));
    date_->setObjectName(QStringLiteral("movieDate"));
    date_->setCalendarPopup(true);
    date_->setDateRange(QDate(1901, 1, 1), QDate(2099, 12, 31));
    at_ = new QTimeEdit(QTime(0, 0).addSecs(int(first.at.count()) * 60));
    at_->setObjectName(QStringLiteral("movieTime"));
    at_->setDisplayFormat(QStringLiteral("HH:mm"));
    every_ = makeNumber("movieEvery", 1, 240, first.everyMin, tr(" min of the day in each frame"));
    form.addRow(tr("Movie"), kind_);
    form.addRow(tr("Date"), date_);
    form.addRow(tr("Time"), at_);
    form.addRow(tr("Step"), every_);
}

void MovieDialog::makePicture(QFormLayout& form, const MovieChoice& first) {
    area_ =
        makeList("movieArea", tr("What all frames show: a map, or the view from where its camera stands"));
    area_->addItem(tr("What changes and what its shadows reach, or the places"));
    area_->addItem(tr("The region of the study"));
    area_->addItem(tr("The ground that the view shows"));
    area_->addItem(tr("The view in 3D, as it is shown"));
    area_->setCurrentIndex(int(first.area));
    size_ = makeList("movieSize", tr("Small pictures make small files, which matters for GIF"));
    for (const QSize& size : movieSizes)
        size_->addItem(tr("%1 × %2 pixels").arg(size.width()).arg(size.height()), size);
    size_->setCurrentIndex(std::max(0, size_->findData(first.format.size)));
    rate_ = makeNumber("movieRate", 1, 60, int(first.format.framesPerSecond), tr(" frames per second"));
    title_ = new QLineEdit(QString::fromStdString(first.title));
    title_->setObjectName(QStringLiteral("movieTitle"));
    title_->setMaxLength(200);
    form.addRow(tr("Area"), area_);
    form.addRow(tr("Size"), size_);
    form.addRow(tr("Speed"), rate_);
    form.addRow(tr("Title"), title_);
}

void MovieDialog::makeButtons(QFormLayout& form) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    auto* write = pushButton(tr("Export..."), "movieWrite",
                             tr("Asks for a file: MP4 for players, GIF for pages and mail"));
    buttons->addButton(write, QDialogButtonBox::AcceptRole);
    form.addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        Q_EMIT chosen(choice());
        accept();
    });
}

MovieChoice MovieDialog::choice() const {
    MovieChoice choice;
    choice.kind = MovieChoice::Kind(kind_->currentData().toInt());
    choice.area = MovieChoice::Area(area_->currentIndex());
    if (choice.kind == MovieChoice::Kind::swipe && choice.area == MovieChoice::Area::camera)
        choice.area = MovieChoice::Area::view;
    choice.date = civilOf(date_->date());
    choice.at = std::chrono::minutes(at_->time().hour() * 60 + at_->time().minute());
    choice.everyMin = every_->value();
    choice.format = {size_->currentData().toSize(), double(rate_->value())};
    choice.title = title_->text().trimmed().toStdString();
    return choice;
}

void MovieDialog::setMoment(CivilDate date, std::chrono::minutes at) {
    const QSignalBlocker quietDate(date_), quietTime(at_);
    const QDate there = dateOf(date);
    QDate here(date_->date().year(), there.month(), there.day());
    if (!here.isValid()) here = QDate(date_->date().year(), 2, 28);
    date_->setDate(here);
    at_->setTime(QTime(0, 0).addSecs(int(at.count()) * 60));
}

void MovieDialog::update() {
    const auto kind = MovieChoice::Kind(kind_->currentData().toInt());
    every_->setEnabled(kind == MovieChoice::Kind::day);
    at_->setEnabled(kind != MovieChoice::Kind::day);
    date_->setEnabled(kind != MovieChoice::Kind::period);
    area_->setEnabled(kind != MovieChoice::Kind::swipe);  // of the map: two cities in plan
    date_->setDisplayFormat(kind == MovieChoice::Kind::year ? QStringLiteral("yyyy") : dayOfYear());
}

}  // namespace noonmark
