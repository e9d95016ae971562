#include "app/report/maps/raster_style.h"

#include <QXmlStreamWriter>
#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

/// A colour from this value of the file on, or, of classes, up to it.
struct StyleItem {
    double value;
    QColor colour;
    QString label;
};

constexpr int smoothStops = 32;  // between which QGIS interpolates; the eye sees no difference to the ramp

QString styleNumber(double value) {
    return std::isinf(value) ? QStringLiteral("inf") : QString::number(value, 'g', 10);
}

std::vector<StyleItem> smoothItems(const ColourScale& scale) {
    std::vector<StyleItem> items;
    const QString unit = QString::fromUtf8(scale.unit().data(), qsizetype(scale.unit().size()));
    for (int i = 0; i <= smoothStops; ++i) {
        const double shown = std::lerp(scale.low, scale.high, double(i) / smoothStops);
        items.push_back({scale.valueOf(shown), toColour(scale.colourOf(shown)),
                         QStringLiteral("%1 %2").arg(shown, 0, 'g', 4).arg(unit).trimmed()});
    }
    return items;
}

// A class of sun from 2 to 4 h is one of shadow from the sunlit time less 4 h up to that less 2 h.
std::vector<StyleItem> classItems(const ColourScale& scale) {
    std::vector<StyleItem> items;
    for (const ColourClass& one : scale.classes()) {
        const double end = scale.quantity.isSun() ? one.low : one.high;
        items.push_back({std::isinf(end) ? std::abs(end) : scale.valueOf(end), toColour(one.colour),
                         QString::fromStdString(one.label)});
    }
    return items;
}

std::vector<StyleItem> itemsOf(const Legend& legend) {
    const ColourScale scale = coloursOf(legend);
    std::vector<StyleItem> items = scale.breaks.empty() ? smoothItems(scale) : classItems(scale);
    std::ranges::sort(items, {}, &StyleItem::value);
    return items;
}

void writeTransparency(QXmlStreamWriter& xml, const Legend& legend) {
    xml.writeStartElement(QStringLiteral("rasterTransparency"));
    if (legend.colours && legend.colours->leavesZeroFree()) {
        xml.writeStartElement(QStringLiteral("singleValuePixelList"));
        xml.writeEmptyElement(QStringLiteral("pixelListEntry"));
        for (const char* end : {"min", "max"}) xml.writeAttribute(QLatin1String(end), QStringLiteral("0"));
        xml.writeAttribute(QStringLiteral("percentTransparent"), QStringLiteral("100"));
        xml.writeEndElement();
    }
    xml.writeEndElement();
}

void writeShader(QXmlStreamWriter& xml, const std::vector<StyleItem>& items, bool discrete) {
    xml.writeStartElement(QStringLiteral("rastershader"));
    xml.writeStartElement(QStringLiteral("colorrampshader"));
    xml.writeAttribute(QStringLiteral("colorRampType"),
                       discrete ? QStringLiteral("DISCRETE") : QStringLiteral("INTERPOLATED"));
    xml.writeAttribute(QStringLiteral("classificationMode"), QStringLiteral("1"));
    xml.writeAttribute(QStringLiteral("clip"), QStringLiteral("0"));
    for (const StyleItem& item : items) {
        xml.writeEmptyElement(QStringLiteral("item"));
        xml.writeAttribute(QStringLiteral("value"), styleNumber(item.value));
        xml.writeAttribute(QStringLiteral("color"), item.colour.name());
        xml.writeAttribute(QStringLiteral("alpha"), QStringLiteral("255"));
        xml.writeAttribute(QStringLiteral("label"), item.label);
    }
    xml.writeEndElement();
    xml.writeEndElement();
}

void writeRenderer(QXmlStreamWriter& xml, const Legend& legend) {
    const std::vector<StyleItem> items = itemsOf(legend);
    const auto finite = [](const StyleItem& item) { return std::isfinite(item.value); };
    const auto last = std::ranges::find_if(items.rbegin(), items.rend(), finite);
    xml.writeStartElement(QStringLiteral("rasterrenderer"));
    xml.writeAttribute(QStringLiteral("type"), QStringLiteral("singlebandpseudocolor"));
    xml.writeAttribute(QStringLiteral("band"), QStringLiteral("1"));
    xml.writeAttribute(QStringLiteral("opacity"), QStringLiteral("1"));
    xml.writeAttribute(QStringLiteral("alphaBand"), QStringLiteral("-1"));
    xml.writeAttribute(QStringLiteral("classificationMin"), styleNumber(items.front().value));
    xml.writeAttribute(QStringLiteral("classificationMax"), styleNumber(last->value));
    writeTransparency(xml, legend);
    writeShader(xml, items, legend.colours && !legend.colours->breaks.empty());
    xml.writeEndElement();
}

}  // namespace

std::string rasterStyle(const Legend& legend) {
    QByteArray text;
    QXmlStreamWriter xml(&text);
    xml.setAutoFormatting(true);
    xml.writeDTD(QStringLiteral("<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>"));
    xml.writeStartElement(QStringLiteral("qgis"));
    xml.writeAttribute(QStringLiteral("version"), QStringLiteral("3.22.0"));
    xml.writeAttribute(QStringLiteral("styleCategories"), QStringLiteral("Symbology"));
    xml.writeStartElement(QStringLiteral("pipe"));
    writeRenderer(xml, legend);
    xml.writeEndDocument();
    return text.toStdString();
}

}  // namespace noonmark
