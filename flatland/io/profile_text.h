// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "flatland/study/profile_lines.h"

namespace flatland {

/// Profiles as CSV (RFC 4180) with the header
/// `curve,segment,t,u,x,y,screen,nw,k,kPrime,lambda,feature,offset,perspective,sum,ratio`, a row
/// for a sample in order of t; `segment` counts from 0 on each curve, and nothing is continuous
/// from one segment to the next (profile.h). A field is empty where the quantity has no value.
std::string profileToCsv(const std::vector<Profile>& profiles);

/// The same with only the columns of one plot: `curve,segment,t,u,screen` and one for each of
/// `quantities`.
std::string profileToCsv(const Profile& profile, const std::vector<ProfileQuantity>& quantities);

}  // namespace flatland
