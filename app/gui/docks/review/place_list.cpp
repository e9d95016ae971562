#include "app/gui/docks/review/place_list.h"

#include <QAbstractItemDelegate>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QObject>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <set>

#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/review/glazing/verdict_links.h"
#include "app/gui/docks/review/verdict_table.h"
#include "app/gui/session/study/region_text.h"
#include "core/describe/text.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

constexpr int nameRole = Qt::UserRole;

// By name; those without a name of their own come last.
std::vector<const Place*> order(const std::vector<Place>& places) {
    std::vector<const Place*> ordered;
    for (const Place& place : places) ordered.push_back(&place);
    std::ranges::stable_sort(ordered, [](const Place* a, const Place* b) {
        const bool first = hasOwnName(*a), second = hasOwnName(*b);
        return first != second ? first
                               : QString::compare(QString::fromStdString(a->name),
                                                  QString::fromStdString(b->name), Qt::CaseInsensitive) < 0;
    });
    return ordered;
}

QPushButton* makeSmallButton(const QString& text, const QString& tip, QHBoxLayout& row) {
    auto* button = new QPushButton(text);
    button->setToolTip(tip);
    row.addWidget(button);
    return button;
}

}  // namespace

PlaceList::PlaceList(QWidget* parent)
    : QWidget(parent),
      filter_(new QLineEdit),
      list_(new QListWidget),
      count_(new QLabel),
      kind_(new QComboBox),
      drawing_(makeDrawing()) {
    filter_->setObjectName(QStringLiteral("placeFilter"));
    filter_->setPlaceholderText(tr("Find a place"));
    filter_->setClearButtonEnabled(true);
    list_->setObjectName(QStringLiteral("reviewPlaces"));
    list_->setUniformItemSizes(true);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    list_->setMinimumHeight(90);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    count_->setWordWrap(true);
    auto* row = new QHBoxLayout;
    QPushButton* all = makeSmallButton(tr("All"), tr("Tick all places"), *row);
    all->setObjectName(QStringLiteral("allPlacesToReview"));
    QPushButton* none = makeSmallButton(tr("None"), tr("Tick no place"), *row);
    QPushButton* screen = makeSmallButton(
        tr("In reach"),
        tr("Tick the places that the proposal's shadow reaches, found anew for each proposal"), *row);
    screen->setObjectName(QStringLiteral("screen"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(count_);
    column->addWidget(filter_);
    column->addWidget(list_, 1);
    column->addWidget(drawing_);
    connect(filter_, &QLineEdit::textChanged, this, &PlaceList::filter);
    connect(list_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) { takeItem(*item); });
    connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item != nullptr) Q_EMIT highlighted(item->data(nameRole).toString().toStdString());
    });
    connect(all, &QPushButton::clicked, this, [this] { checkAll(true); });
    connect(none, &QPushButton::clicked, this, [this] { checkAll(false); });
    connect(screen, &QPushButton::clicked, this, &PlaceList::screenRequested);
}

// What is drawn needs a kind, since rules treat kinds differently: it is asked for beside the button.
QWidget* PlaceList::makeDrawing() {
    kind_->setObjectName(QStringLiteral("drawnKind"));
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    kind_->setMinimumContentsLength(8);  // a long name shall not widen the panel
    kind_->setToolTip(tr("What the place is that is drawn, of the kinds that the rule is about"));
    auto* draw = new QPushButton(tr("Draw place"));
    draw->setObjectName(QStringLiteral("drawReviewPlace"));
    draw->setToolTip(
        tr("Click the place's corners on the ground; double click or Enter finishes. Its name "
           "can then be typed in the list."));
    connect(draw, &QPushButton::clicked, this,
            [this] { Q_EMIT drawRequested(PlaceKind(kind_->currentData().toInt())); });
    auto* drawing = new QWidget;
    auto* row = new QHBoxLayout(drawing);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(draw, 1);
    row->addWidget(kind_, 1);
    return drawing;
}

void PlaceList::setKinds(const std::vector<PlaceKind>& kinds) {
    drawing_->setVisible(!kinds.empty());
    const QVariant chosen = kind_->currentData();
    kind_->clear();
    for (const PlaceKind kind : kinds) kind_->addItem(describeKind(kind), int(kind));
    kind_->setCurrentIndex(std::max(0, kind_->findData(chosen)));
}

// While places in reach are being found, no place can be ticked, but a name be typed.
void PlaceList::editName(const std::string& place) {
    QListWidgetItem* item = rowOf(QString::fromStdString(place));
    if (item == nullptr) return;
    list_->setEnabled(true);
    list_->setCurrentItem(item);
    list_->scrollToItem(item);
    list_->setFocus();
    list_->editItem(item);
}

QListWidgetItem* PlaceList::rowOf(const QString& place) const {
    for (int i = 0; i < list_->count(); ++i)
        if (list_->item(i)->data(nameRole).toString() == place) return list_->item(i);
    return nullptr;
}

// The field in a row whose name is being typed, else null.
QLineEdit* PlaceList::typingIn(const QListWidgetItem& item) const {
    return qobject_cast<QLineEdit*>(list_->indexWidget(list_->indexFromItem(&item)));
}

// Rows are about to hold other places: a field that stayed open would rename one of these.
std::optional<PlaceList::Typing> PlaceList::stopTyping() {
    const QListWidgetItem* item = list_->currentItem();
    QLineEdit* field = item == nullptr ? nullptr : typingIn(*item);
    if (field == nullptr) return {};
    const Typing typing{item->data(nameRole).toString(), field->text()};
    Q_EMIT list_->itemDelegate()->closeEditor(field, QAbstractItemDelegate::NoHint);
    return typing;
}

void PlaceList::resumeTyping(const Typing& typing) {
    editName(typing.place.toStdString());
    const QListWidgetItem* item = list_->currentItem();
    QLineEdit* field = item == nullptr ? nullptr : typingIn(*item);
    if (field != nullptr && field->text() != typing.text) field->setText(typing.text);
}

// It was ticked, or its name was typed.
void PlaceList::takeItem(const QListWidgetItem& item) {
    const std::string name = item.data(nameRole).toString().toStdString();
    if (item.text() == placeName(name)) return take();
    const std::string typed = item.text().trimmed().toStdString();
    stopTyping();  // it is taken or refused; rows that are shown meanwhile shall not resume it
    Q_EMIT renamed(name, typed);
}

namespace {

std::set<std::string> listTicked(const std::vector<Place>& places, const ReviewChoice& choice,
                                 const ReviewSession::Reach* reach) {
    if (!reach && choice.reviewed == ReviewedPlaces::chosen)
        return {choice.places.begin(), choice.places.end()};
    std::set<std::string> ticked;
    for (const Place& place : reach ? reach->kept->places : places) ticked.insert(place.name);
    return ticked;
}

}  // namespace

void PlaceList::show(const std::vector<Place>& places, const ReviewChoice& choice,
                     const ReviewSession::Reach* reach, bool isFinding) {
    const QSignalBlocker block(list_);
    const std::optional<Typing> typing = stopTyping();
    const QString current =
        list_->currentItem() == nullptr ? QString() : list_->currentItem()->data(nameRole).toString();
    const std::set<std::string> ticked = listTicked(places, choice, reach);
    while (list_->count() > int(places.size())) delete list_->takeItem(list_->count() - 1);
    while (list_->count() < int(places.size())) new QListWidgetItem(list_);
    std::vector<const Place*> ordered = order(places);
    // Those in reach come first: they may be few of thousands.
    if (reach)
        std::ranges::stable_partition(ordered,
                                      [&](const Place* place) { return ticked.contains(place->name); });
    for (std::size_t i = 0; i < ordered.size(); ++i) {
        const Place& place = *ordered[i];
        QListWidgetItem& item = *list_->item(int(i));
        item.setText(placeName(place.name));
        item.setData(nameRole, QString::fromStdString(place.name));
        item.setFlags(item.flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
        item.setCheckState(ticked.contains(place.name) ? Qt::Checked : Qt::Unchecked);
        QString tip = tr("%1, %2").arg(describeKind(place.kind), describeArea(area(place)));
        if (reach && reach->reasons.contains(place.name))
            tip += u'\n' + QString::fromStdString(reach->reasons.at(place.name));
        item.setToolTip(tip);
    }
    filter(filter_->text());
    list_->setEnabled(!isFinding);
    list_->setCurrentItem(rowOf(current));
    if (typing) resumeTyping(*typing);
    if (isFinding) return count_->setText(tr("Only those in reach of the shadow; they are being found"));
    reach ? showReach(reach->kept->places.size(), places.size()) : count();
}

void PlaceList::count() {
    int checked = 0;
    for (int i = 0; i < list_->count(); ++i) checked += list_->item(i)->checkState() == Qt::Checked ? 1 : 0;
    count_->setText(tr("%1 of %2 place(s) ticked", "", list_->count())
                        .arg(formatCount(quint64(checked)), formatCount(quint64(list_->count()))));
}

void PlaceList::showReach(std::size_t reached, std::size_t of) {
    count_->setText(
        tr("%1 of %2 place(s) in reach of the shadow; the others' tooltips say why not", "", pluralNumber(of))
            .arg(formatCount(reached), formatCount(of)));
}

void PlaceList::take() {
    std::vector<std::string> names;
    for (int i = 0; i < list_->count(); ++i)
        if (list_->item(i)->checkState() == Qt::Checked)
            names.push_back(list_->item(i)->data(nameRole).toString().toStdString());
    const bool all = int(names.size()) == list_->count();
    if (all) names.clear();
    Q_EMIT chosen(all, names);
}

// Of those that the filter shows.
void PlaceList::checkAll(bool on) {
    {
        const QSignalBlocker block(list_);
        for (int i = 0; i < list_->count(); ++i)
            if (!list_->item(i)->isHidden()) list_->item(i)->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    }
    take();
}

void PlaceList::filter(const QString& part) {
    for (int i = 0; i < list_->count(); ++i)
        list_->item(i)->setHidden(!list_->item(i)->text().contains(part, Qt::CaseInsensitive));
}

namespace {

constexpr std::array colouredVerdicts{Verdict::pass, Verdict::borderline, Verdict::fail,
                                      Verdict::notApplicable};

/// A place with its reviews, by their index in the answer's study.
struct ColouredPlace {
    Place place;
    std::vector<std::size_t> reviews;
};

std::vector<ColouredPlace> listPlaces(const ReviewAnswer& answer) {
    std::vector<ColouredPlace> places;
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < answer.study.places.size(); ++i) {
        const Place& place = answer.placeOf(i);
        const auto [at, isNew] = known.try_emplace(place.name, places.size());
        if (isNew) places.push_back({place, {}});
        places[at->second].reviews.push_back(i);
    }
    return places;
}

Verdict worstOf(const ReviewAnswer& answer, const ColouredPlace& place) {
    Verdict worst = answer.study.places[place.reviews.front()].verdict;
    for (const std::size_t review : place.reviews)
        if (isWorse(worst, answer.study.places[review].verdict)) worst = answer.study.places[review].verdict;
    return worst;
}

Legend makeVerdictLegend(const ReviewAnswer& answer) {
    Legend legend;
    legend.title = QStringLiteral(NM_TEXT("Verdicts on places"));
    legend.unit = ruleName(answer.question.rule.name);
    for (const Verdict verdict : colouredVerdicts)
        legend.classes.push_back({tileColour(verdict), QString::fromUtf8(nameOf(verdict).data())});
    return legend;
}

QString describe(const ReviewAnswer& answer, const ColouredPlace& place) {
    QStringList verdicts;
    for (const std::size_t review : place.reviews) verdicts << describeVerdict(answer.study.places[review]);
    return QObject::tr("%1   %2").arg(placeName(place.place.name), verdicts.join(u' '));
}

GroundPicture::Pixel verdictPixel(const QColor& colour) {
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue()), 255};
}

}  // namespace

std::shared_ptr<const PlaceView> makePlaceVerdicts(const std::shared_ptr<const ReviewAnswer>& answer) {
    if (!answer || answer->study.places.empty()) return nullptr;
    const auto places = std::make_shared<const std::vector<ColouredPlace>>(listPlaces(*answer));
    std::vector<Place> shapes;
    std::vector<GroundPicture::Pixel> colours;
    for (const ColouredPlace& place : *places) {
        shapes.push_back(place.place);
        colours.push_back(verdictPixel(tileColour(worstOf(*answer, place))));
    }
    const auto painted = std::make_shared<const PlacePicture>(shapes);
    const auto view = std::make_shared<PlaceView>();
    view->picture = painted->coloured(colours);
    view->legend = makeVerdictLegend(*answer);
    const QString to = scenarioName(answer->question.to);
    const QString from = scenarioName(answer->question.from);
    view->note = to == from ? QObject::tr("%1 as it stands").arg(to)
                            : QObject::tr("%1 compared with %2").arg(to, from);
    view->describe = [answer, places, painted](glm::dvec2 point) {
        const auto place = painted->placeAt(point);
        return place ? describe(*answer, (*places)[*place]) : QString();
    };
    return view;
}

}  // namespace noonmark
