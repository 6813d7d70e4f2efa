// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/values/Units.h"

#include <QCoreApplication>

#include <cmath>
#include <numbers>

namespace toile::ui {
namespace {

constexpr double degreesPerRadian = 180 / std::numbers::pi;

QString decimalNumber(double value, int decimals) {
    const double rounded = std::round(value * std::pow(10, decimals)) == 0 ? 0.0 : value; // no "-0.0"
    return QString::number(rounded, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212));
}

} // namespace

UnitFormat formatOf(Quantity quantity) {
    switch (quantity) {
    case Quantity::length: return {1000, 0, 1, QStringLiteral(" mm")};
    case Quantity::area: return {1e4, 0, 1, QStringLiteral(" cm²")};
    case Quantity::angle: return {degreesPerRadian, 0, 1, QStringLiteral("°")};
    case Quantity::foldAngle: return {-degreesPerRadian, 180, 0, QStringLiteral("°")};
    case Quantity::arealDensity: return {1000, 0, 1, QStringLiteral(" g/m²")};
    case Quantity::tension: return {1, 0, 1, QStringLiteral(" N/m")};
    case Quantity::force: return {1, 0, 1, QStringLiteral(" N")};
    case Quantity::bending: return {1e6, 0, 2, QStringLiteral(" µN·m")};
    case Quantity::acceleration: return {1, 0, 2, QStringLiteral(" m/s²")};
    case Quantity::damping: return {1, 0, 2, QStringLiteral(" 1/s")};
    case Quantity::time: return {1, 0, 2, QStringLiteral(" s")};
    case Quantity::shortTime: return {1000, 0, 1, QStringLiteral(" ms")};
    case Quantity::speed: return {1000, 0, 0, QStringLiteral(" mm/s")};
    case Quantity::wind: return {1, 0, 2, QStringLiteral(" m/s")};
    case Quantity::pressure: return {1, 0, 1, QStringLiteral(" Pa")};
    case Quantity::factor: return {1, 0, 2, {}};
    case Quantity::count: return {1, 0, 0, {}};
    }
    return {};
}

double shown(Quantity quantity, double value) {
    const UnitFormat format = formatOf(quantity);
    return format.offset + format.perUnit * value;
}

double fromShown(Quantity quantity, double number) {
    const UnitFormat format = formatOf(quantity);
    return (number - format.offset) / format.perUnit;
}

QString textOf(Quantity quantity, double value) {
    const UnitFormat format = formatOf(quantity);
    return decimalNumber(shown(quantity, value), format.decimals) + format.suffix;
}

QString differenceTextOf(Quantity quantity, double value) {
    const QString text = textOf(quantity, value);
    return value > 0 ? QLatin1Char('+') + text : text;
}

} // namespace toile::ui
