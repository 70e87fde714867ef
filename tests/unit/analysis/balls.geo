// Two bodies of revolution that touch at the origin: above it one whose lower end has the radius R1,
// below it one with the radius R2 (below 0 a socket, 0 a flat). Each is rolled about the centre of its sphere: its pole,
// and its mesh with it, is off1, off2 beside the origin, in the directions turn1, turn2. Elements of
// sizes h1, h2 up to 1.2 contact radii a, growing from there on.
SetFactory("OpenCASCADE");
DefineConstant[ R1 = 20, R2 = 30, a = 0.4, h1 = 0.1, h2 = 0.13, seed = 1, method = 6,
                off1 = 0.1, off2 = 0.1, turn1 = 0.3, turn2 = 2 ];
Mesh.ElementOrder = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.RandomSeed = seed;
Mesh.Algorithm = method;
L = 8 * a;
w = 1.75 * a; // of what may touch
all() = {};
For b In {1 : 2}
  s = (b == 1) ? 1 : -1;
  r = (b == 1) ? R1 : R2;
  flat = (r == 0);
  r = flat ? 1 : r;
  g = (r > 0) ? 1 : -1;
  off = (b == 1) ? off1 : off2;
  turn = (b == 1) ? turn1 : turn2;
  p = newp;
  Point(p) = {0, 0, s * r};
  Point(p + 1) = {0, 0, 0};
  Point(p + 2) = {w, 0, flat ? 0 : s * (r - g * Sqrt(r * r - w * w))};
  Point(p + 3) = {L, 0, flat ? 0 : s * (r - g * Sqrt(r * r - L * L))};
  Point(p + 4) = {L, 0, s * L};
  Point(p + 5) = {0, 0, s * L};
  c = newl;
  If (flat)
    Line(c) = {p + 1, p + 2};
    Line(c + 1) = {p + 2, p + 3};
  Else
    Circle(c) = {p + 1, p, p + 2};
    Circle(c + 1) = {p + 2, p, p + 3};
  EndIf
  Line(c + 2) = {p + 3, p + 4};
  Line(c + 3) = {p + 4, p + 5};
  Line(c + 4) = {p + 5, p + 1};
  k = newll;
  Curve Loop(k) = {c, c + 1, c + 2, c + 3, c + 4};
  f = news;
  Plane Surface(f) = {k};
  e() = Extrude { {0, 0, 1}, {0, 0, 0}, 2 * Pi }{ Surface{f}; };
  v = e(1);
  If (flat)
    Translate { off * Cos(turn), off * Sin(turn), 0 }{ Volume{v}; }
  Else
    Rotate { {Cos(turn), Sin(turn), 0}, {0, 0, s * r}, off / r }{ Volume{v}; }
  EndIf
  all(b - 1) = v;
EndFor
Physical Volume("UP") = {all(0)};
Physical Volume("DOWN") = {all(1)};
For b In {1 : 2}
  v = all(b - 1);
  t() = Abs(Boundary{ Volume{v}; });
  near() = {};
  far() = {};
  For i In {0 : #t() - 1}
    bb() = BoundingBox Surface { t(i) };
    If (bb(3) - bb(0) < 4 * a)
      near() += t(i);
    ElseIf (bb(5) - bb(2) > 0.6 * L || Fabs(bb(2)) > 0.6 * L)
      far() += t(i);
    EndIf
  EndFor
  If (b == 1)
    Physical Surface("CAP1") = near();
    Physical Surface("FAR1") = far();
  Else
    Physical Surface("CAP2") = near();
    Physical Surface("FAR2") = far();
  EndIf
  c() = Abs(Boundary{ Surface{t()}; });
  h = (b == 1) ? h1 : h2;
  Field[2 * b] = MathEval;
  Field[2 * b].F = Sprintf("%g + 0.4*(Sqrt(x*x + y*y + z*z) - %g + Abs(Sqrt(x*x + y*y + z*z) - %g))/2",
                           h, 1.2 * a, 1.2 * a);
  Field[2 * b + 1] = Restrict;
  Field[2 * b + 1].InField = 2 * b;
  Field[2 * b + 1].VolumesList = {v};
  Field[2 * b + 1].SurfacesList = {t()};
  Field[2 * b + 1].CurvesList = {c()};
EndFor
Field[6] = Min;
Field[6].FieldsList = {3, 5};
Background Field = 6;
