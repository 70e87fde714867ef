// Quarter ring ri < r < ro of ns x ns bricks across and nt along, 0 <= z <= b.
DefineConstant[ ri = 4.12, ro = 4.32, b = 0.1, ns = 1, nt = 6, serendipity = 1 ];
SetFactory("OpenCASCADE");
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = serendipity;
Point(1) = {ri, 0, 0};
Point(2) = {ro, 0, 0};
Point(3) = {ro, 0, b};
Point(4) = {ri, 0, b};
For i In {1:4}
  Line(i) = {i, i % 4 + 1};
EndFor
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Transfinite Curve{1:4} = ns + 1;
Transfinite Surface{1};
Recombine Surface{1};
Extrude{{0, 0, 1}, {0, 0, 0}, Pi / 2}{ Surface{1}; Layers{nt}; Recombine; }
Physical Volume("BODY") = {1};
