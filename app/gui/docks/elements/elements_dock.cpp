#include "app/gui/docks/elements/elements_dock.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/point/point_inspector.h"
#include "app/gui/docks/study_form/element_form.h"
#include "app/gui/docks/study_form/face_form.h"
#include "app/gui/docks/study_form/line_form.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/view_presets.h"
#include "core/describe/shown_as.h"
#include "core/study/elements/element_tables.h"

namespace noonmark {

namespace {

const std::string& textIn(const MeasuredElement& element, int column) {
    if (column == ElementModel::id) return element.id;
    return element.buildingName.empty() ? element.building : element.buildingName;
}

const Figure& figureOf(int column) { return pointFigures().rows()[std::size_t(column - ElementModel::sun)]; }

bool isInHours(const Figure& figure) {
    return figure.unit == FigureUnit::hours || figure.unit == FigureUnit::hoursADay;
}

// NaN where there is none.
double numberIn(const MeasuredElement& element, double possibleMin, int column) {
    if (column == ElementModel::floor) return element.floor ? *element.floor : std::nan("");
    if (column == ElementModel::facing) return element.azimuthDeg;
    const Figure& figure = figureOf(column);
    const MapPoint point{&element, possibleMin};
    const double value = figure.get(&point);
    return isInHours(figure) ? value / minutesPerHour : value;
}

bool isText(int column) { return column == ElementModel::id || column == ElementModel::building; }

QVariant valueOf(const MeasuredElement& element, double possibleMin, int column) {
    if (isText(column)) return QString::fromStdString(textIn(element, column));
    const double number = numberIn(element, possibleMin, column);
    return std::isnan(number) ? QVariant() : QVariant(number);
}

int decimalsOf(int column) { return column < ElementModel::sun ? 0 : figureOf(column).shownDecimals; }

QVariant textOf(const QVariant& value, int column) {
    if (!value.isValid() || isText(column)) return value;
    return groupDigits(value.toDouble(), decimalsOf(column));
}

}  // namespace

void ElementModel::show(std::shared_ptr<const ElementMap> map) {
    beginResetModel();
    map_ = std::move(map);
    endResetModel();
}

int ElementModel::rowCount(const QModelIndex& parent) const {
    return map_ && !parent.isValid() ? int(map_->elements.size()) : 0;
}

int ElementModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : sun + int(pointFigures().rows().size());
}

QVariant ElementModel::data(const QModelIndex& index, int role) const {
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (index.column() > building ? Qt::AlignRight : Qt::AlignLeft));
    if (role != Qt::DisplayRole && role != valueRole) return {};
    const QVariant value =
        valueOf(map_->elements[std::size_t(index.row())], map_->possibleMin, index.column());
    return role == valueRole ? value : textOf(value, index.column());
}

QVariant ElementModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    const std::array<QString, sun> names{tr("Point"), tr("Building"), tr("Floor"), tr("Facing, °")};
    return section < sun ? names[std::size_t(section)] : headingOf(figureOf(section));
}

ElementFilter::ElementFilter(QObject* parent) : QSortFilterProxyModel(parent) {
    setSortRole(ElementModel::valueRole);
}

void ElementFilter::setText(const QString& text) {
    text_ = text;
    invalidateFilter();
}

void ElementFilter::setBelowHours(double hours) {
    belowHours_ = hours;
    invalidateFilter();
}

// Without a QVariant for each value: a quarter of a million rows are sorted at a click. Rows without a number
// come first.
bool ElementFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const ElementMap& map = *static_cast<const ElementModel*>(sourceModel())->map();
    const MeasuredElement &a = map.elements[std::size_t(left.row())],
                          &b = map.elements[std::size_t(right.row())];
    const int column = left.column();
    if (isText(column)) return textIn(a, column) < textIn(b, column);
    const double first = numberIn(a, map.possibleMin, column), second = numberIn(b, map.possibleMin, column);
    return std::isnan(first) ? !std::isnan(second) : first < second;
}

bool ElementFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const auto at = [&](int column) {
        return sourceModel()->index(row, column, parent).data(ElementModel::valueRole);
    };
    if (belowHours_ > 0 && at(ElementModel::sun).toDouble() >= belowHours_) return false;
    return text_.isEmpty() || at(ElementModel::id).toString().contains(text_, Qt::CaseInsensitive) ||
           at(ElementModel::building).toString().contains(text_, Qt::CaseInsensitive);
}

ElementsDock::ElementsDock(QWidget* parent)
    : QWidget(parent),
      model_(new ElementModel(this)),
      filter_(new ElementFilter(this)),
      text_(new QLineEdit),
      below_(numberField(0, 24, 1, 0.5, tr(" h"))),
      count_(new QLabel),
      table_(new QTableView) {
    filter_->setSourceModel(model_);
    placeFields();
    connectFields();
    count();
}

void ElementsDock::placeFields() {
    text_->setObjectName(QStringLiteral("elementFilter"));
    text_->setPlaceholderText(tr("Part of a building or point"));
    text_->setToolTip(tr("Lists only the points whose id or building contains this text"));
    text_->setClearButtonEnabled(true);
    below_->setObjectName(QStringLiteral("elementBelow"));
    below_->setSpecialValueText(tr("any"));
    below_->setToolTip(tr("Lists only the points with less sun a day than this"));
    table_->setObjectName(QStringLiteral("elementTable"));
    table_->setModel(filter_);
    table_->resizeColumnsToContents();  // until there are values, to the titles
    table_->setSortingEnabled(true);
    table_->sortByColumn(-1, Qt::AscendingOrder);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    table_->setToolTip(tr("Select rows to see their points in the view; double-click to go there"));
    auto* line = new QHBoxLayout;
    line->addWidget(text_, 1);
    line->addWidget(new QLabel(tr("Sun below")));
    line->addWidget(below_);
    line->addWidget(count_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->addLayout(line);
    column->addWidget(table_, 1);
}

void ElementsDock::connectFields() {
    connect(text_, &QLineEdit::textChanged, this, [this](const QString& text) {
        filter_->setText(text);
        count();
    });
    connect(below_, &QDoubleSpinBox::valueChanged, this, [this](double hours) {
        filter_->setBelowHours(hours);
        count();
    });
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [this] { Q_EMIT highlighted(selected()); });
    connect(table_, &QTableView::activated, this,
            [this](const QModelIndex& index) { Q_EMIT goToRequested(elementOf(index)); });
}

void ElementsDock::show(std::shared_ptr<const ElementMap> map) {
    if (map == model_->map()) return;
    const bool first = model_->map() == nullptr;
    model_->show(std::move(map));
    if (first && model_->map()) table_->resizeColumnsToContents();
    count();
}

void ElementsDock::count() {
    const int all = model_->rowCount(), shown = filter_->rowCount();
    const QString number = formatCount(quint64(all));
    count_->setText(all == 0 ? tr("No points measured")
                    : shown == all
                        ? tr("%1 point(s)", "", all).arg(number)
                        : tr("%1 of %2 point(s)", "", all).arg(formatCount(quint64(shown)), number));
}

std::size_t ElementsDock::elementOf(const QModelIndex& index) const {
    return std::size_t(filter_->mapToSource(index).row());
}

std::vector<std::size_t> ElementsDock::selected() const {
    std::vector<std::size_t> elements;
    for (const QModelIndex& index : table_->selectionModel()->selectedRows())
        elements.push_back(elementOf(index));
    return elements;
}

void ElementsDock::select(std::size_t element) {
    const QModelIndex source = model_->index(int(element), 0);
    if (!source.isValid()) return;
    if (!filter_->mapFromSource(source).isValid()) {
        text_->clear();
        below_->setValue(0);
    }
    const QModelIndex row = filter_->mapFromSource(source);
    table_->selectRow(row.row());
    table_->scrollTo(row);
}

ElementLinks::ElementLinks(ElementsDock& dock, ViewPanel& panel) : dock_(dock), panel_(panel) {
    connect(&dock_, &ElementsDock::highlighted, this, [this](const std::vector<std::size_t>& elements) {
        if (panel_.results().showsElements()) panel_.view().tiles().highlight(elements);
    });
    connect(&dock_, &ElementsDock::goToRequested, this, &ElementLinks::goTo);
    connect(&panel_.navigator(), &ViewNavigator::clicked, this, &ElementLinks::click);
}

void ElementLinks::goTo(std::size_t element) {
    const MeasuredElement& at = dock_.model().map()->elements[element];
    const auto azimuth = std::isnan(at.azimuthDeg) ? std::nullopt : std::optional(at.azimuthDeg);
    panel_.view().setPose(faceWall(panel_.view().pose(), glm::dvec3(at.position), azimuth));
}

void ElementLinks::click(QPointF pixel) {
    if (panel_.drawing() || panel_.view().tiles().tiles().empty()) return;
    const auto pick = panel_.navigator().pickAt(pixel);
    const auto element = pick ? panel_.results().elementAt(pick->position) : std::nullopt;
    if (element) dock_.select(*element);
}

namespace {

void addPickedFace(FaceForm& form, const City& city, const Pick& pick) {
    if (!pick.building || *pick.building >= city.buildings.size()) return;
    const auto face = findFaceAt(*city.buildings[*pick.building], pick.position, glm::dvec3(pick.normal));
    if (face) form.addFace(QString::fromStdString(*face));
}

void addPickedPoint(PointListForm& form, const City& city, const Pick& pick) {
    const PointQuestion question = questionAt(city, pick);
    const auto rounded = [](std::optional<double> value, double to) {
        return value ? std::optional(std::round(*value / to) * to) : value;
    };
    form.add({{}, question.at, rounded(question.heightM, 0.01), rounded(question.facingDeg, 0.1)});
}

}  // namespace

ElementPicking::ElementPicking(Workbench& workbench, ViewPanel& panel)
    : workbench_(workbench), panel_(panel) {
    connect(&panel_.navigator(), &ViewNavigator::clicked, this, &ElementPicking::click);
}

void ElementPicking::serve(ElementForm& form) {
    forms_.push_back(&form);
    connect(&form.faces(), &FaceForm::pickingBegan, this, [this, &form] { begin(form, true); });
    connect(&form.list(), &PointListForm::pickingBegan, this, [this, &form] { begin(form, false); });
}

void ElementPicking::begin(const ElementForm& form, bool faces) {
    for (ElementForm* other : forms_) {
        if (other != &form || !faces) other->faces().endPicking();
        if (other != &form || faces) other->list().endPicking();
    }
    panel_.messages().showNote(faces ? tr("Click walls in the view to choose their faces.")
                                     : tr("Click the ground, roofs or walls in the view to add points."));
}

void ElementPicking::click(QPointF pixel) {
    if (panel_.drawing() || !workbench_.city()) return;
    for (ElementForm* form : forms_) {
        if (!form->faces().picking() && !form->list().picking()) continue;
        const auto pick = panel_.navigator().pickAt(pixel);
        if (!pick) return;
        const City& city = workbench_.city()->city();
        form->faces().picking() ? addPickedFace(form->faces(), city, *pick)
                                : addPickedPoint(form->list(), city, *pick);
    }
}

}  // namespace noonmark
