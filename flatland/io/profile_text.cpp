// SPDX-License-Identifier: MIT
#include "flatland/io/profile_text.h"

#include "flatland/io/number_text.h"

namespace flatland {

namespace {

constexpr const char* kLineEnd = "\r\n";

std::string field(const std::optional<double>& value) { return numberText(value, ""); }

/// Minus zero tells a reader nothing here.
std::string field(double value) { return numberText(value == 0.0 ? 0.0 : value); }

const char* nameOf(ProfileQuantity quantity) {
  switch (quantity) {
    case ProfileQuantity::Curvature:
      return "k";
    case ProfileQuantity::Lambda:
      return "lambda";
    case ProfileQuantity::Feature:
      return "feature";
    case ProfileQuantity::Offset:
      return "offset";
    case ProfileQuantity::Perspective:
      return "perspective";
    case ProfileQuantity::Sum:
      return "sum";
    case ProfileQuantity::Ratio:
      break;
  }
  return "ratio";
}

/// Calls `row` with the fields that name a sample, up to its arc length, and the sample.
template <class Row>
void forEachRow(const Profile& profile, Row row) {
  for (std::size_t i = 0; i < profile.segments.size(); ++i) {
    for (const ProfileSample& sample : profile.segments[i].samples) {
      row(std::to_string(profile.curve) + ',' + std::to_string(i) + ',' + field(sample.t) + ',' +
              field(sample.u) + ',',
          sample);
    }
  }
}

}  // namespace

std::string profileToCsv(const std::vector<Profile>& profiles) {
  std::string text =
      "curve,segment,t,u,x,y,screen,nw,k,kPrime,lambda,feature,offset,perspective,sum,ratio";
  text += kLineEnd;
  for (const Profile& profile : profiles) {
    forEachRow(profile, [&text](const std::string& place, const ProfileSample& s) {
      text += place + field(s.point.x()) + ',' + field(s.point.y()) + ',' + field(s.screen) + ',' +
              field(s.nw) + ',' + field(s.k) + ',' + field(s.kPrime) + ',' + field(s.lambda) + ',' +
              field(s.feature) + ',' + field(s.offset) + ',' + field(s.perspective) + ',' +
              field(s.sum()) + ',' + field(s.ratio) + kLineEnd;
    });
  }
  return text;
}

std::string profileToCsv(const Profile& profile, const std::vector<ProfileQuantity>& quantities) {
  std::string text = "curve,segment,t,u,screen";
  for (const ProfileQuantity quantity : quantities) text += std::string(",") + nameOf(quantity);
  text += kLineEnd;
  forEachRow(profile, [&](const std::string& place, const ProfileSample& s) {
    text += place + field(s.screen);
    for (const ProfileQuantity quantity : quantities) text += ',' + field(valueOf(s, quantity));
    text += kLineEnd;
  });
  return text;
}

}  // namespace flatland
