#include "app/window/widgets/mesh_fields.h"

#include <QComboBox>

#include "core/io/read_city.h"

namespace noonmark {

QComboBox* upAxisField() {
    auto* field = new QComboBox;
    field->setObjectName(QStringLiteral("upAxis"));
    field->setToolTip(QObject::tr("Y is usual in OBJ and glTF, Z in models from GIS and CAD"));
    field->addItem(QObject::tr("Automatic"), int(UpAxis::automatic));
    field->addItem(QObject::tr("Y"), int(UpAxis::y));
    field->addItem(QObject::tr("Z"), int(UpAxis::z));
    return field;
}

QComboBox* meshUnitField() {
    auto* field = new QComboBox;
    field->setObjectName(QStringLiteral("meshUnit"));
    field->setToolTip(QObject::tr("Unit of the mesh's coordinates, which the file does not state"));
    addUnits(*field);
    return field;
}

void addUnits(QComboBox& field) {
    field.addItem(QObject::tr("metres"), int(LengthUnit::metres));
    field.addItem(QObject::tr("feet"), int(LengthUnit::feet));
    field.addItem(QObject::tr("US survey feet"), int(LengthUnit::usSurveyFeet));
    field.addItem(QObject::tr("centimetres"), int(LengthUnit::centimetres));
    field.addItem(QObject::tr("millimetres"), int(LengthUnit::millimetres));
    field.addItem(QObject::tr("inches"), int(LengthUnit::inches));
}

void choose(QComboBox& field, int data) { field.setCurrentIndex(field.findData(data)); }

}  // namespace noonmark
